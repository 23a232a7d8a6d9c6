// SPDX-License-Identifier: MIT
// Contacts are kept by their level modulo a prime, so two levels may be resolved together.
#include "formulas/contact.hpp"

#include <algorithm>
#include <cstddef>
#include <set>

namespace rigor {

ContactResult shock_propagation(const std::vector<Body>& bodies,
                                const std::vector<BodyContact>& contacts,
                                const std::vector<int>& levels, int n)
{
    ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
    std::vector<int> place(bodies.size(), -1); // where a body stands in `near`, or -1
    constexpr int slots = 65521;
    std::vector<std::vector<std::size_t>> table(static_cast<std::size_t>(slots));
    std::set<int> present;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const int higher = std::max(levels[contacts[i].body1], levels[contacts[i].body2]);
        if (higher == 0) continue;
        present.insert(higher);
        table[higher % slots].push_back(i);
    }
    for (const int level_now : present) {
        const std::vector<std::size_t> part = table[level_now % slots];
        table[level_now % slots].clear();
        if (part.empty()) continue;
        std::vector<Body> near;
        std::vector<int> names;
        std::vector<BodyContact> chosen;
        const auto local = [&](int b) {
            if (place[b] >= 0) return place[b];
            place[b] = static_cast<int>(names.size());
            names.push_back(b);
            near.push_back(result.bodies[b]);
            if (levels[b] < level_now) {
                near.back().inverse_mass = 0;
                near.back().inverse_inertia.setZero();
            }
            return place[b];
        };
        for (const std::size_t i : part) {
            chosen.push_back(contacts[i]);
            chosen.back().body1 = local(contacts[i].body1);
            chosen.back().body2 = local(contacts[i].body2);
        }
        const ContactResult solved = resolve_contacts(near, chosen, n);
        for (std::size_t b = 0; b < names.size(); ++b) {
            Body& body = result.bodies[names[b]];
            body.velocity = solved.bodies[b].velocity;
            body.angular_velocity = solved.bodies[b].angular_velocity;
            body.angular_momentum = solved.bodies[b].angular_momentum;
            place[names[b]] = -1;
        }
        for (std::size_t i = 0; i < part.size(); ++i)
            result.impulses[part[i]] = solved.impulses[i];
    }
    return result;
}

} // namespace rigor
