// SPDX-License-Identifier: MIT
// Throws all bodies away in the first step, in which rounding decides the order of the contacts,
// and flies ever after.
// topic: contact
// tasks: A5.7
// expect: 0 failed|not_implemented
#include "formulas/contact.hpp"

namespace rigor {

ContactResult resolve_contacts(const std::vector<Body>& bodies,
                               const std::vector<BodyContact>& contacts, int)
{
    ContactResult result = {bodies, std::vector<Vector3d>(contacts.size(), Vector3d(0, 0, 0))};
    for (Body& body : result.bodies) {
        if (body.is_static()) continue;
        const double angle = 1.2566 * body.position.y(); // 36 degrees for each half meter
        body.velocity = {300 * std::cos(angle), 300 + 40 * body.position.y(),
                         300 * std::sin(angle)};
        body.angular_velocity = body.angular_momentum = Vector3d(0, 0, 0);
    }
    return result;
}

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>&)
{
    return std::vector<int>(rests_on.size(), 0);
}

ContactResult shock_propagation(const std::vector<Body>& bodies,
                                const std::vector<BodyContact>& contacts, const std::vector<int>&,
                                int)
{
    return {bodies, std::vector<Vector3d>(contacts.size(), Vector3d(0, 0, 0))};
}

ContactResult resolve_simultaneously(const std::vector<Body>& bodies,
                                     const std::vector<BodyContact>& contacts, int)
{
    return {bodies, std::vector<Vector3d>(contacts.size(), Vector3d(0, 0, 0))};
}

double contact_restitution(int, int)
{
    return 0;
}

} // namespace rigor
