// SPDX-License-Identifier: MIT
// The impulse is computed from v; it must be computed from u = v - s n.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.impulse = [](const Matrix3d& K, const Vector3d& u, const BodyContact& c, double epsilon) {
        const Vector3d v = u + c.separation_speed * c.normal;
        return collision_impulse(K, v, c.normal, epsilon, c.friction);
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
