// SPDX-License-Identifier: MIT
// Helpers of the tests of topic `rotation`: conversions to Eigen's quaternion and back, the
// bodies of the lecture's examples, and random input for one step. Expected values come from plain
// Eigen.
#pragma once

#include "support/random.hpp"

#include <cmath>

namespace rigor::testing {

inline Eigen::Quaterniond eigen(const Quaternion& q)
{
    return {q.s, q.v.x(), q.v.y(), q.v.z()};
}

inline Quaternion plain(const Eigen::Quaterniond& q)
{
    return {q.w(), q.vec()};
}

inline Matrix3d matrix(const Vector3d& x, const Vector3d& y, const Vector3d& z)
{
    Matrix3d columns;
    columns << x, y, z;
    return columns;
}

inline double length(const Quaternion& q)
{
    return eigen(q).norm();
}

/// The turn about `vector` by |vector| [rad], as a unit quaternion.
inline Eigen::Quaterniond turn(const Vector3d& vector)
{
    if (vector.isZero(0)) return Eigen::Quaterniond::Identity();
    return Eigen::Quaterniond(Eigen::AngleAxisd(vector.norm(), vector.normalized()));
}

/// Rotation vector that takes orientation b to orientation a, at most half a turn [rad]. It uses
/// atan2, since acos cannot resolve angles below 2e-8.
inline Vector3d turn_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b)
{
    const Eigen::Quaterniond d = a * b.conjugate();
    const double sine = d.vec().norm();
    if (sine == 0) return Vector3d::Zero();
    const double sign = d.w() < 0 ? -1 : 1;
    return sign * 2 * std::atan2(sine, std::abs(d.w())) / sine * d.vec();
}

inline Matrix3d world_inverse(const BodyInertia& body, const Quaternion& q)
{
    const Matrix3d R = eigen(q).toRotationMatrix();
    return R * body.inverse_inertia * R.transpose();
}

inline double kinetic_energy_of_rotation(const BodyInertia& body, const RigidState& state)
{
    const Vector3d& L = state.angular_momentum;
    return 0.5 * L.dot(world_inverse(body, state.orientation) * L);
}

/// The box of 1 × 2 × 3 m and 12 kg: I = (13, 10, 5) kg m².
inline BodyInertia box()
{
    return {1.0 / 12, Vector3d(1.0 / 13, 1.0 / 10, 1.0 / 5).asDiagonal()};
}

/// The box with its center at rest, its axes along the world's, and the angular velocity ω.
inline RigidState spinning_box(const Vector3d& omega)
{
    RigidState state;
    state.angular_momentum = Vector3d(13, 10, 5).cwiseProduct(omega);
    return state;
}

/// The arguments of a time step.
struct StepCase {
    RigidState state;
    BodyInertia body;
    Wrench wrench;
    double time_step = 0;
    double speed = 0; // |ω| [rad/s]
};

inline StepCase random_step(Random& random)
{
    StepCase c;
    const Matrix3d I_body = random.inertia();
    const Eigen::Quaterniond q = random.eigen_quaternion();
    const Matrix3d R = q.toRotationMatrix();
    const Vector3d w = 3 * random.vector();
    c.state.position = random.vector();
    c.state.orientation = plain(q);
    c.state.velocity = random.vector();
    c.state.angular_momentum = R * I_body * R.transpose() * w;
    c.body.inverse_mass = 1 / random.mass();
    c.body.inverse_inertia = I_body.inverse();
    c.wrench.force = random.vector();
    c.wrench.torque = random.vector();
    c.time_step = random.uniform(0.01, 0.1);
    c.speed = w.norm();
    return c;
}

} // namespace rigor::testing
