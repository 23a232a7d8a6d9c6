// SPDX-License-Identifier: MIT
// Computes a body's rotation matrix, then the inverse inertia in world space, then the angular
// velocity. The distance of two orientations p and q is the smaller one of |p - q| and |p + q|,
// because q and -q are the same rotation.
#include "rigid/bodies/orientation.hpp"

#include "formulas/inertia.hpp"
#include "formulas/rotation.hpp"
#include "geometry/shapes/pose.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

Matrix3d body_rotation(Integrator integrator, const RigidState& state)
{
    if (integrator == Integrator::matrix) return rotation_matrix(state.orientation);
    return to_matrix(state.orientation);
}

Matrix3d inverse_inertia(Integrator integrator, const RigidBody& body, const RigidState& state)
{
    const Matrix3d& I_inverse = body.inverse.inverse_inertia;
    if (body.is_static || body.is_isotropic) return I_inverse;
    return world_inverse_inertia(body_rotation(integrator, state), I_inverse);
}

Vector3d angular_velocity(Integrator integrator, const RigidBody& body, const RigidState& state)
{
    return inverse_inertia(integrator, body, state) * state.angular_momentum;
}

Body body_in_world(Integrator integrator, const RigidBody& rigid)
{
    const RigidState& s = rigid.state;
    Body body;
    body.position = s.position;
    if (rigid.is_static) return body;
    body.inverse_mass = rigid.inverse.inverse_mass;
    body.inverse_inertia = inverse_inertia(integrator, rigid, s);
    body.velocity = s.velocity;
    body.angular_momentum = s.angular_momentum;
    body.angular_velocity = body.inverse_inertia * s.angular_momentum;
    return body;
}

Quaternion nearer_quaternion_of(const Matrix3d& R, const Quaternion& p)
{
    const Quaternion q = quaternion_of(R);
    return q.s * p.s + q.v.dot(p.v) < 0 ? Quaternion{-q.s, -q.v} : q;
}

double orientation_distance(const Quaternion& p, const Quaternion& q)
{
    const double difference = (p.s - q.s) * (p.s - q.s) + (p.v - q.v).squaredNorm();
    const double sum = (p.s + q.s) * (p.s + q.s) + (p.v + q.v).squaredNorm();
    return std::sqrt(std::min(difference, sum));
}

} // namespace rigor
