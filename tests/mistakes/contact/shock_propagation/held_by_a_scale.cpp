// SPDX-License-Identifier: MIT
// A body that is held has 2^80 times its mass, not an infinite one, so what is far heavier still
// moves it.
#include "formulas/contact.hpp"

#include "formulas/collision.hpp"

#include <algorithm>
#include <map>

namespace rigor {

ContactResult shock_propagation(const std::vector<Body>& bodies,
                                const std::vector<BodyContact>& contacts,
                                const std::vector<int>& levels, int n)
{
    const double hold = 0x1p-80;
    ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
    std::map<int, std::vector<std::size_t>> by_level;
    for (std::size_t i = 0; i < contacts.size(); ++i)
        by_level[std::max(levels[contacts[i].body1], levels[contacts[i].body2])].push_back(i);
    by_level.erase(0);
    for (auto& [level, members] : by_level) {
        std::stable_sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
            return contacts[a].depth > contacts[b].depth;
        });
        for (int k = 0; k < n; ++k) {
            for (const std::size_t i : members) {
                const BodyContact& c = contacts[i];
                Body& b1 = result.bodies[c.body1];
                Body& b2 = result.bodies[c.body2];
                const bool held1 = levels[c.body1] < level, held2 = levels[c.body2] < level;
                if ((held1 || b1.is_static()) && (held2 || b2.is_static())) continue;
                const Vector3d u =
                    relative_velocity(b1, b2, c.point) - c.separation_speed * c.normal;
                if (u.dot(c.normal) >= 0) continue;
                const Matrix3d K1 =
                    impulse_matrix(b1.inverse_mass, b1.inverse_inertia, b1.position, c.point);
                const Matrix3d K2 =
                    impulse_matrix(b2.inverse_mass, b2.inverse_inertia, b2.position, c.point);
                const Matrix3d K = (held1 ? hold : 1) * K1 + (held2 ? hold : 1) * K2;
                const Vector3d j =
                    collision_impulse(K, u, c.normal, contact_restitution(k, n), c.friction);
                result.impulses[i] += j;
                if (!held1) b1 = apply_impulse(b1, c.point, j);
                if (!held2) b2 = apply_impulse(b2, c.point, -j);
            }
        }
    }
    return result;
}

} // namespace rigor
