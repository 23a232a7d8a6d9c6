// SPDX-License-Identifier: MIT
// Once a contact is at rest collision_impulse adds nothing, and nothing is ever taken back.
#include "mistakes/contact/one_contact.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const BodyContact& c = contacts[i];
        const Matrix3d K = impulse_matrix_of(bodies, c);
        if (K.isZero(0)) continue;
        result.impulses[i] = c.impulse;
        apply(result.bodies, c, c.impulse);
    }
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const BodyContact& c = contacts[i];
            const Vector3d& n = c.normal;
            const Matrix3d K = impulse_matrix_of(bodies, c);
            if (K.isZero(0)) continue;
            const Vector3d v = velocity_of(result.bodies, c), j = result.impulses[i];
            const Vector3d u = v - c.separation_speed * n;
            const Vector3d change = collision_impulse(K, u, n, 0, c.friction);
            result.impulses[i] = j + change;
            apply(result.bodies, c, change);
        }
    }
    return result;
}

} // namespace rigor
