// SPDX-License-Identifier: MIT
// Computes how far bodies move in a step, relative to each other and never to the origin of the
// world. So a scene that moves at a constant velocity gives the same distances as at rest.
#include "rigid/detection/travel.hpp"

#include "rigid/bodies/orientation.hpp"

#include <algorithm>
#include <numbers>

namespace rigor {

double angle_turned(const World& world, const RigidBody& body, const RigidState& state,
                    double time_step)
{
    if (body.is_static)
        return time_step * mean_drive_velocity(*body.drive, world.time, time_step).angular.norm();
    const Quaternion& q = state.orientation;
    const Vector3d L = Eigen::Quaterniond(q.s, -q.v.x(), -q.v.y(), -q.v.z()) *
                       state.angular_momentum; // in object space
    return time_step * (body.inverse.inverse_inertia * L).norm();
}

Travel travel_of(const RigidState& from, const RigidState& to, double angle, double radius,
                 double time_step)
{
    // A rotation by the angle α changes the quaternion by about α/2. The factor 2.5 instead of 2
    // allows for a quarter more than α, which covers the approximation and an axis that changes its
    // direction.
    constexpr double angle_per_distance = 2.5;
    double turned = angle_per_distance * orientation_distance(from.orientation, to.orientation);
    if (angle > std::numbers::pi) turned = std::max(turned, 2.0); // a point moves by up to 2 radii
    return {to.position - from.position, time_step * to.velocity, turned * radius};
}

double path_between(const Travel& a, const Travel& b)
{
    return std::max((a.moved - b.moved).norm(), (a.at_last_velocity - b.at_last_velocity).norm()) +
           a.turned + b.turned;
}

std::vector<Travel> frames_of(const World& world, std::span<const RigidState> flown,
                              double time_step)
{
    std::vector<Travel> frames;
    Travel center;
    double mass = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const RigidBody& body = world.bodies[i];
        Travel motion;
        if (!body.is_still()) motion = travel_of(body.state, flown[i], 0, 0, time_step);
        if (!body.is_static && !body.is_still()) {
            mass += body.mass;
            center.moved += body.mass * motion.moved;
            center.at_last_velocity += body.mass * motion.at_last_velocity;
            continue;
        }
        if (std::none_of(frames.begin(), frames.end(), [&](const Travel& known) {
                return known.moved == motion.moved &&
                       known.at_last_velocity == motion.at_last_velocity;
            }))
            frames.push_back(motion);
    }
    if (frames.empty() && mass > 0)
        frames.push_back({center.moved / mass, center.at_last_velocity / mass, 0});
    return frames;
}

Vector3d frame_of_bounds(const World& world, const std::vector<Travel>& frames)
{
    const bool any_still = std::any_of(world.bodies.begin(), world.bodies.end(),
                                       [](const RigidBody& body) { return body.is_still(); });
    return any_still || frames.empty() ? Vector3d(0, 0, 0) : frames.front().moved;
}

} // namespace rigor
