// SPDX-License-Identifier: MIT
// Body 2 receives -j.
#include "mistakes/contact/one_contact.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
    const std::vector<int> order = by_depth(contacts);
    for (int k = 0; k < n; ++k) {
        const double epsilon = contact_restitution(k, n);
        for (int i : order) {
            const BodyContact& c = contacts[i];
            const Vector3d u = velocity_of(result.bodies, c) - c.separation_speed * c.normal;
            if (u.dot(c.normal) >= 0) continue;
            const Matrix3d K = impulse_matrix_of(result.bodies, c);
            const Vector3d j = collision_impulse(K, u, c.normal, epsilon, c.friction);
            result.bodies[c.body1] = apply_impulse(result.bodies[c.body1], c.point, j);
            result.bodies[c.body2] = apply_impulse(result.bodies[c.body2], c.point, j);
            result.impulses[i] += j;
        }
    }
    return result;
}

} // namespace rigor
