// SPDX-License-Identifier: MIT
// Predicts when the contacts of a pair close, from their gaps and from the velocities and forces at
// the start of the step.
#include "rigid/step/approach.hpp"

#include "rigid/bodies/orientation.hpp"

#include <cmath>
#include <limits>

namespace rigor {

double Approach::closes() const
{
    if (gap <= 0) return 0;
    const double root = speed * speed - 2 * rate * gap;
    if (root < 0) return std::numeric_limits<double>::infinity();
    const double divisor = -speed + std::sqrt(root);
    return divisor > 0 ? 2 * gap / divisor : std::numeric_limits<double>::infinity();
}

std::optional<Approach> first_to_close(const World& world, const ContactProblem& problem,
                                       const ContactPair& pair)
{
    std::optional<Approach> first;
    double earliest = std::numeric_limits<double>::infinity();
    for (int i = pair.first; i < pair.last; ++i) {
        const ContactConstraint& c = problem.contacts[i];
        const auto velocity = [&](int body) -> Vector3d {
            const RigidBody& b = world.bodies[body];
            if (b.is_static) {
                const Body& driven = problem.bodies[body];
                return driven.velocity + driven.angular_velocity.cross(c.point - driven.position);
            }
            const Vector3d w = angular_velocity(world.settings.integrator, b, b.state);
            return b.state.velocity + w.cross(c.point - b.state.position);
        };
        const double speed = (velocity(c.body1) - velocity(c.body2)).dot(c.normal);
        const Approach approach{c.gap, speed, c.force_speed / problem.time_step};
        const double time = approach.closes();
        if (time >= earliest) continue;
        earliest = time;
        first = approach;
    }
    return first;
}

} // namespace rigor
