// SPDX-License-Identifier: MIT
// There are at most 20 iterations.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    return ContactsOneAtATime()(bodies, contacts, std::min(n, 20));
}

} // namespace rigor
