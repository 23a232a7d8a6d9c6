// SPDX-License-Identifier: MIT
// Quantities that follow from a body's orientation: rotation matrix, inverse inertia and angular
// velocity in world space.
#pragma once

#include "rigid/bodies/body.hpp"
#include "rigid/bodies/settings.hpp"

namespace rigor {

/// Rotation matrix of a body, by `to_matrix`. With the integrator `matrix`, Eigen computes it
/// instead, because assignment A1 uses this integrator and `to_matrix` belongs to A3.
Matrix3d body_rotation(Integrator integrator, const RigidState& state);

/// I(t)⁻¹ = R I_body⁻¹ Rᵀ by `world_inverse_inertia`. For an isotropic body this is I_body⁻¹,
/// whatever R is.
Matrix3d inverse_inertia(Integrator integrator, const RigidBody& body, const RigidState& state);

/// ω = I(t)⁻¹ L [rad/s]
Vector3d angular_velocity(Integrator integrator, const RigidBody& body, const RigidState& state);

/// The body in world space, in the form that the formulas take. For a static body only the position
/// is set; so the velocities are 0 even if the body is driven.
Body body_in_world(Integrator integrator, const RigidBody& body);

/// The quaternion of a rotation matrix, by `quaternion_of`. Of the two quaternions q and -q of this
/// rotation, the result is the one nearer to `p`.
Quaternion nearer_quaternion_of(const Matrix3d& R, const Quaternion& p);

/// min(|p - q|, |p + q|): about half the angle [rad] between two orientations, if this angle is
/// small. The minimum is taken because q and -q are the same orientation.
double orientation_distance(const Quaternion& p, const Quaternion& q);

} // namespace rigor
