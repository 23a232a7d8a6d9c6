// SPDX-License-Identifier: MIT
// An iteration visits every contact, not only the deepest one that approaches.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.stops_after_one = true;
    return wrong(bodies, contacts, n);
}

} // namespace rigor
