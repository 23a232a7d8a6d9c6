// SPDX-License-Identifier: MIT
// Bodies and worlds for the tests of the engine.
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/mass.hpp"
#include "rigid/bodies/world.hpp"
#include "rigid/step/step.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

#include <cmath>
#include <numbers>

namespace rigor::testing {

inline constexpr double g = 9.81; // [m/s²]

inline Quaternion turn(const Vector3d& axis, double angle)
{
    return {std::cos(angle / 2), std::sin(angle / 2) * axis.normalized()};
}

inline RigidBody body_of(const Shape& shape, const Vector3d& X, const Material& material = {},
                         const Quaternion& q = {})
{
    RigidBody body;
    body.name = "body";
    Part part;
    part.shape = shape;
    body.parts = {part};
    body.material = material;
    body.state.position = X;
    body.state.orientation = q;
    set_mass_from_parts(body);
    return body;
}

inline RigidBody fixed(const Shape& shape, const Material& material, const Vector3d& X = {0, 0, 0},
                       const Quaternion& q = {})
{
    RigidBody body = body_of(Sphere{1}, X, material, q);
    body.name = "ground";
    body.parts[0].shape = shape;
    body.is_static = true;
    set_mass_from_parts(body);
    return body;
}

inline World world_of(std::vector<RigidBody> bodies, const Vector3d& gravity = {0, -g, 0})
{
    World world;
    world.bodies = std::move(bodies);
    world.settings.gravity = gravity;
    return world;
}

inline void run(World& world, int steps, double h)
{
    for (int i = 0; i < steps; ++i)
        step(world, h);
}

inline Vector3d angular_velocity(const RigidBody& body)
{
    const Matrix3d R = rotation_matrix(body.state.orientation);
    return R * body.inverse.inverse_inertia * R.transpose() * body.state.angular_momentum;
}

inline void spin(RigidBody& body, const Vector3d& omega)
{
    const Matrix3d R = rotation_matrix(body.state.orientation);
    body.state.angular_momentum = R * body.inertia * R.transpose() * omega;
}

inline const Vector3d free_moments(13, 10, 5); // [kg m²]

/// A body of 12 kg without a shape.
inline RigidBody free_box(const Vector3d& omega = {0, 0, 0})
{
    RigidBody body;
    body.name = "box";
    set_mass(body, 12, free_moments.asDiagonal().toDenseMatrix());
    spin(body, omega);
    return body;
}

inline Eigen::Quaterniond eigen(const Quaternion& q)
{
    return {q.s, q.v.x(), q.v.y(), q.v.z()};
}

/// Sums over all moving bodies, about the origin.
struct Totals {
    Vector3d momentum = Vector3d::Zero(), angular_momentum = Vector3d::Zero();
    double kinetic_energy = 0;
};

inline Totals totals(const World& world)
{
    Totals sum;
    for (const RigidBody& body : world.bodies) {
        if (body.is_static) continue;
        const RigidState& s = body.state;
        sum.momentum += body.mass * s.velocity;
        sum.angular_momentum += s.position.cross(body.mass * s.velocity) + s.angular_momentum;
        sum.kinetic_energy += body.mass * s.velocity.squaredNorm() / 2 +
                              s.angular_momentum.dot(angular_velocity(body)) / 2;
    }
    return sum;
}

} // namespace rigor::testing
