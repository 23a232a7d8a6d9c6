// SPDX-License-Identifier: MIT
// Friction coefficients above 1 are taken as 1.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.impulse = [](const Matrix3d& K, const Vector3d& u, const BodyContact& c, double epsilon) {
        return collision_impulse(K, u, c.normal, epsilon, std::min(c.friction, 1.0));
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
