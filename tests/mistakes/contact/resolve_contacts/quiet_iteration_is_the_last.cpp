// SPDX-License-Identifier: MIT
// The iterations end after one without an impulse. But a jammed contact may get its first impulse
// later, where the restitution is higher.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.stops_if_quiet = true;
    return wrong(bodies, contacts, n);
}

} // namespace rigor
