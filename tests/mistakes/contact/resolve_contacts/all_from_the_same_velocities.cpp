// SPDX-License-Identifier: MIT
// A contact has to see what those before it in the same iteration did.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.sees_those_before = false;
    return wrong(bodies, contacts, n);
}

} // namespace rigor
