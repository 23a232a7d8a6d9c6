// SPDX-License-Identifier: MIT
// Bodies and worlds for the tests of the engine.
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/mass.hpp"
#include "rigid/bodies/world.hpp"
#include "rigid/step/step.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

#include <cmath>
#include <memory>
#include <numbers>

namespace rigor::testing {

inline constexpr double g = 9.81; // [m/s²]

inline Quaternion turn(const Vector3d& axis, double angle)
{
    return {std::cos(angle / 2), std::sin(angle / 2) * axis.normalized()};
}

inline Shape mesh_of(const TriangleMesh& mesh)
{
    return Mesh{std::make_shared<SolidMesh>(mesh)};
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

/// A body of 12 kg with the principal moments `free_moments` and without a shape.
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

/// Stacks of cubes with edges of 1 m, side by side. Along x and along z, each cube is up to 1 cm
/// off the axis of its stack.
inline World stacks(int count, int height)
{
    std::vector<RigidBody> bodies = {fixed(Plane{}, {0, 0.5})};
    Random random(7);
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < height; ++k)
            bodies.push_back(body_of(Box{{1, 1, 1}},
                                     Vector3d(3 * i + 0.01 * random.uniform(-1, 1), 0.5 + k,
                                              0.01 * random.uniform(-1, 1)),
                                     {0, 0.5}));
    World world = world_of(bodies);
    world.settings.contact_method = ContactMethod::simultaneous;
    world.settings.formulas_are_reference = true;
    return world;
}

/// The largest distance between the positions of a body in two worlds [m].
inline double largest_distance(const World& a, const World& b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i)
        largest =
            std::max(largest, (a.bodies[i].state.position - b.bodies[i].state.position).norm());
    return largest;
}

} // namespace rigor::testing
