// SPDX-License-Identifier: MIT
// Bodies that approach slower than 1e-6 m/s count as separating.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.impulse = [](const Matrix3d& K, const Vector3d& u, const BodyContact& c,
                       double epsilon) -> Vector3d {
        if (u.dot(c.normal) > -1e-6) return Vector3d::Zero();
        return collision_impulse(K, u, c.normal, epsilon, c.friction);
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
