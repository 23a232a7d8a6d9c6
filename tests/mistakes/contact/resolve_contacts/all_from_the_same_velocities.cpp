// SPDX-License-Identifier: MIT
// A contact must see the velocities that the contacts before it changed in the same iteration.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.sees_those_before = false;
    return wrong(bodies, contacts, n);
}

} // namespace rigor
