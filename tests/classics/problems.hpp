// SPDX-License-Identifier: MIT
// What the problems share: worlds that run with the reference's formulas, motions that are given,
// and slopes. A problem names its source and has its closed form above its test case.
#pragma once

#include "framework/rigid/worlds.hpp"
#include "support/catch.hpp"
#include "support/sweep.hpp"

#include <cmath>
#include <memory>
#include <numbers>

namespace rigor::testing {

using std::numbers::pi;

/// A world of these bodies that runs with the reference's formulas.
inline World solved(std::vector<RigidBody> bodies, const Vector3d& gravity = {0, -g, 0})
{
    World world = world_of(std::move(bodies), gravity);
    world.settings.formulas_are_reference = true;
    return world;
}

/// Takes steps of length h for the duration T [s].
inline void run_until(World& world, double T, double h)
{
    run(world, static_cast<int>(std::lround(T / h)), h);
}

/// Gravity on a slope whose frame is turned, so that its surface is y = 0 and x points downhill.
inline Vector3d gravity_on_slope(double angle)
{
    return {g * std::sin(angle), -g * std::cos(angle), 0};
}

/// A ball with a given mass.
inline RigidBody ball_of_mass(double radius, double mass, const Vector3d& X,
                              const Material& material = {})
{
    RigidBody ball = body_of(Sphere{radius}, X, material);
    set_mass(ball, mass, 0.4 * mass * radius * radius * Matrix3d::Identity());
    return ball;
}

/// The energy of a body under gravity, which is 0 at rest with its center at y = 0 [J].
inline double energy_of(const RigidBody& body)
{
    const RigidState& s = body.state;
    return body.mass * (s.velocity.squaredNorm() / 2 + g * s.position.y()) +
           angular_velocity(body).dot(s.angular_momentum) / 2;
}

/// A body whose motion is given.
inline RigidBody driven(const Shape& shape, const Material& material, const Vector3d& X,
                        Drive drive, const Quaternion& q = {})
{
    RigidBody body = fixed(shape, material, X, q);
    drive.first_position = X;
    drive.first_orientation = q;
    body.drive = std::make_shared<const Drive>(drive);
    body.state = driven_state(drive, 0);
    return body;
}

inline Drive moving(const Vector3d& velocity)
{
    Drive drive;
    drive.velocity = velocity;
    return drive;
}

inline Drive turning(const Vector3d& omega)
{
    Drive drive;
    drive.angular_velocity = omega;
    return drive;
}

inline Drive shaking(const Vector3d& amplitude, double frequency, double phase = 0)
{
    Drive drive;
    drive.amplitude = amplitude;
    drive.frequency = frequency;
    drive.phase = phase;
    return drive;
}

} // namespace rigor::testing
