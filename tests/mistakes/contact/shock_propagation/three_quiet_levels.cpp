// SPDX-License-Identifier: MIT
// It stops after three levels in a row that needed no impulse, though bodies above them may fall.
#include "formulas/contact.hpp"

#include <algorithm>
#include <cstddef>
#include <map>

namespace rigor {

ContactResult shock_propagation(const std::vector<Body>& bodies,
                                const std::vector<BodyContact>& contacts,
                                const std::vector<int>& levels, int n)
{
    ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
    std::vector<int> place(bodies.size(), -1);     // where a body stands in `near`, or -1
    std::map<int, std::vector<std::size_t>> parts; // the contacts of each level
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const int higher = std::max(levels[contacts[i].body1], levels[contacts[i].body2]);
        if (higher > 0) parts[higher].push_back(i);
    }
    int quiet = 0; // levels in a row at which nothing happened
    for (const auto& entry : parts) {
        const int level_now = entry.first;
        const std::vector<std::size_t>& part = entry.second;
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
        bool pushed = false;
        for (const Vector3d& j : solved.impulses)
            if (!j.isZero(0)) pushed = true;
        quiet = pushed ? 0 : quiet + 1;
        if (quiet == 3) break; // the stack stands
    }
    return result;
}

} // namespace rigor
