// SPDX-License-Identifier: MIT
// Two bodies that approach each other at a point, and their mechanics in plain Eigen, with which
// the tests of topic `collision` compare.
#pragma once

#include "formulas/types.hpp"
#include "support/random.hpp"

#include <cmath>

namespace rigor::testing {

/// Velocity of the point x of a body: v = ω × (x - X) + V
inline Vector3d velocity_at(const Body& body, const Vector3d& x)
{
    return body.angular_velocity.cross(x - body.position) + body.velocity;
}

/// K of one body. Column i is the change of the velocity at x by a unit impulse along axis i.
inline Matrix3d response_at(const Body& body, const Vector3d& x)
{
    const Vector3d r = x - body.position;
    Matrix3d K;
    for (int i = 0; i < 3; ++i) {
        const Vector3d j = Vector3d::Unit(i);
        const Vector3d spin = body.inverse_inertia * r.cross(j);
        K.col(i) = body.inverse_mass * j + spin.cross(r);
    }
    return K;
}

/// Kinetic energy ½ M V·V + ½ ω·L [J]. That of a static body never changes and counts as 0.
inline double energy(const Body& body)
{
    if (body.is_static()) return 0;
    return body.velocity.squaredNorm() / body.inverse_mass / 2 +
           body.angular_velocity.dot(body.angular_momentum) / 2;
}

/// The body after an impulse j at x.
inline Body kicked(Body body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static()) return body;
    const Vector3d torque = (x - body.position).cross(j);
    body.velocity += body.inverse_mass * j;
    body.angular_momentum += torque;
    body.angular_velocity += body.inverse_inertia * torque;
    return body;
}

/// A static body. It may move, as a conveyor belt does, but no impulse changes its motion.
inline Body static_body(Random& random)
{
    Body body = random.body();
    body.inverse_mass = 0;
    body.inverse_inertia = Matrix3d::Zero();
    return body;
}

struct CollidingPair {
    Body body1, body2;
    Vector3d x, n;      // contact point; unit normal, from body 2 to body 1
    Matrix3d K;         // K₁ + K₂
    Vector3d v;         // v₁ - v₂ at x, v·n < 0
    double restitution; // ε, 0 … 1
    double size;        // |K⁻¹| |v|, about the size of an impulse that changes v [N s]
    double condition;   // |K| |K⁻¹|: bounds how much a division by K magnifies rounding
};

/// A pair of random bodies. Body 2 of every third pair is static.
inline CollidingPair colliding_pair(unsigned seed)
{
    Random random(seed);
    CollidingPair pair;
    pair.body1 = random.body();
    pair.body2 = seed % 3 == 2 ? static_body(random) : random.body();
    pair.x = random.vector();
    pair.n = random.unit_vector();
    pair.K = response_at(pair.body1, pair.x) + response_at(pair.body2, pair.x);
    pair.v = velocity_at(pair.body1, pair.x) - velocity_at(pair.body2, pair.x);
    if (pair.v.dot(pair.n) > 0) pair.n = -pair.n;
    pair.restitution = random.uniform(0, 1);

    const double inverse = pair.K.inverse().norm();
    pair.size = inverse * pair.v.norm();
    pair.condition = inverse * pair.K.norm();
    return pair;
}

/// K of a uniform sphere of mass 1 and any radius where it touches a static floor with its normal
/// along y. A tangential impulse changes the velocity there 7/2 times as much as a normal one.
inline Matrix3d sphere_on_floor()
{
    return Vector3d(3.5, 1, 3.5).asDiagonal();
}

} // namespace rigor::testing
