// SPDX-License-Identifier: MIT
// The restitution is 0 in every iteration, so the first contact carries the whole load.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.restitution = [](int, int) { return 0; };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
