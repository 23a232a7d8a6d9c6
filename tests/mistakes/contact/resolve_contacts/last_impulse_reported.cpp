// SPDX-License-Identifier: MIT
// The result is the sum of each contact's impulses, not the last one.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.report = [](const Vector3d&, const Vector3d& j) { return j; };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
