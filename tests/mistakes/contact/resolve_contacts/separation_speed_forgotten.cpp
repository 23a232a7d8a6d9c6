// SPDX-License-Identifier: MIT
// The contact asks for v·n ≥ s, not for v·n ≥ 0.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.velocity_to_stop = [](const Vector3d& v, const BodyContact&) { return v; };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
