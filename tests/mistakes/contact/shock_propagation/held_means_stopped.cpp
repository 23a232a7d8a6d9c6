// SPDX-License-Identifier: MIT
// A body that is held keeps its velocity: what rests on a moving body moves along.
#include "mistakes/contact/one_contact.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ContactResult result{bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
    const int highest = levels.empty() ? 0 : *std::max_element(levels.begin(), levels.end());
    for (int level = 1; level <= highest; ++level) {
        Bodies held = result.bodies;
        for (std::size_t i = 0; i < held.size(); ++i) {
            if (!(levels[i] < level)) continue;
            held[i].inverse_mass = 0;
            held[i].inverse_inertia.setZero();
            held[i].velocity.setZero();
            held[i].angular_velocity.setZero();
        }
        Contacts chosen;
        std::vector<int> indices;
        for (std::size_t i = 0; i < contacts.size(); ++i)
            if (std::max(levels[contacts[i].body1], levels[contacts[i].body2]) == level) {
                chosen.push_back(contacts[i]);
                indices.push_back(static_cast<int>(i));
            }
        const ContactResult resolved = resolve_contacts(held, chosen, n);
        for (std::size_t i = 0; i < indices.size(); ++i)
            result.impulses[indices[i]] = resolved.impulses[i];
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (levels[i] >= level) result.bodies[i] = resolved.bodies[i];
            result.bodies[i].inverse_mass = bodies[i].inverse_mass;
            result.bodies[i].inverse_inertia = bodies[i].inverse_inertia;
        }
    }
    return result;
}

} // namespace rigor
