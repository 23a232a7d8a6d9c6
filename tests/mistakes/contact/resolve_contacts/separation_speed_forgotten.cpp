// SPDX-License-Identifier: MIT
// The separation speed s is ignored: the condition is v·n ≥ s, not v·n ≥ 0.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.velocity_to_stop = [](const Vector3d& v, const BodyContact&) { return v; };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
