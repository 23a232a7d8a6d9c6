// SPDX-License-Identifier: MIT
// The lower body of a contact can also be body 1 and must then be held fixed.
#include "mistakes/contact/one_contact.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
    for (int level = 1; level <= static_cast<int>(bodies.size()); ++level)
        for (int i : by_depth(contacts)) {
            const BodyContact& c = contacts[i];
            if (std::max(levels[c.body1], levels[c.body2]) != level) continue;
            for (int k = 0; k < n; ++k) {
                Bodies pair = result.bodies;
                if (levels[c.body2] < level) {
                    pair[c.body2].inverse_mass = 0;
                    pair[c.body2].inverse_inertia.setZero();
                }
                const Vector3d u = velocity_of(pair, c) - c.separation_speed * c.normal;
                const Vector3d j = collision_impulse(impulse_matrix_of(pair, c), u, c.normal,
                                                     contact_restitution(k, n), c.friction);
                result.impulses[i] += j;
                apply(pair, c, j);
                result.bodies[c.body1] = pair[c.body1];
                if (levels[c.body2] >= level) result.bodies[c.body2] = pair[c.body2];
            }
        }
    return result;
}

} // namespace rigor
