// SPDX-License-Identifier: MIT
// What follows from a body's orientation: its rotation matrix and its inertia in world space.
#pragma once

#include "rigid/bodies/body.hpp"
#include "rigid/bodies/settings.hpp"

namespace rigor {

/// Rotation matrix of a body: by `to_matrix`, but by Eigen for the integrator `matrix`, whose
/// assignment comes before that formula's.
Matrix3d body_rotation(Integrator integrator, const RigidState& state);

/// I(t)⁻¹ = R I_body⁻¹ Rᵀ by `world_inverse_inertia`; an isotropic body's needs no R.
Matrix3d inverse_inertia(Integrator integrator, const RigidBody& body, const RigidState& state);

/// ω = I(t)⁻¹ L [rad/s]
Vector3d angular_velocity(Integrator integrator, const RigidBody& body, const RigidState& state);

/// min(|p - q|, |p + q|): half the angle [rad] between two orientations, if it is small. Both signs of a
/// quaternion are the same orientation.
double orientation_distance(const Quaternion& p, const Quaternion& q);

} // namespace rigor
