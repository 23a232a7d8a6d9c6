// SPDX-License-Identifier: MIT
// Body 2 must receive the opposite impulse, -j.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.push = [](Bodies& pushed, const BodyContact& c, const Vector3d& j) {
        pushed[c.body1] = apply_impulse(pushed[c.body1], c.point, j);
        pushed[c.body2] = apply_impulse(pushed[c.body2], c.point, j);
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
