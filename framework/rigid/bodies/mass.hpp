// SPDX-License-Identifier: MIT
// Mass, inertia and inverse inertia of a body from its parts. They are computed once for each body
// and not in every step.
#pragma once

#include "rigid/bodies/world.hpp"

namespace rigor {

/// Mass properties of parts, each with its own density, in the frame in which the parts' poses are
/// given.
///
/// Calls the formula of topic `inertia` that belongs to each part's shape. The topic has no formula
/// for cones, tori and the round ends of a capsule; closed forms in mass.cpp are used for them.
/// `world_inertia` is called only for a rotated part whose inertia is not isotropic, and `combine`
/// only for a capsule and for several parts.
MassProperties mass_properties(const std::vector<Part>& parts);

/// Whether I = i δ (i: a number, δ: identity) up to rounding: each element may be off by up to 64
/// times the machine epsilon times i. The result is true for spheres and cubes in any orientation,
/// and for a zero matrix.
bool is_isotropic(const Matrix3d& inertia);

/// Sets the mass and the inertia of a body from its parts' densities, and moves the parts so that
/// the origin of object space is the center of mass. The parts of a static body stay in place, and
/// its mass is 0.
///
/// @return  the center of mass in the frame in which the parts were given; zero for a static body
///          [m]
/// @throws NonFiniteState if the mass, center of mass, inertia, 1/M or I_body⁻¹ is not finite
Vector3d set_mass_from_parts(RigidBody& body);

/// Sets the mass of a body and its inertia about the center of mass, which is the origin of object
/// space. Computes what follows from them: 1/M, I_body⁻¹ through the principal axes, and the
/// symmetries of the inertia. For a static body, the mass, the inertia and their inverses become 0,
/// whatever the arguments are.
///
/// @throws NonFiniteState if the mass, the inertia, 1/M or I_body⁻¹ is not finite
void set_mass(RigidBody& body, double mass, const Matrix3d& inertia);

/// Lets a body turn only about the axis a through its center of mass, by I_body⁻¹ = a aᵀ/(aᵀ I a).
/// If the axis is zero, the body never turns. Call this function after the mass is set. It does
/// nothing to a static body.
///
/// @param axis  in object space, of any length
void let_turn_about(RigidBody& body, const Vector3d& axis);

/// The angular momentum R I_body ω of a body's rotation. If the body can turn about one axis only,
/// this result may differ from `state.angular_momentum`: only the component of
/// `state.angular_momentum` along the axis turns the body, and the bearing of the axis takes up the
/// rest.
Vector3d own_angular_momentum(const RigidBody& body, const RigidState& state);

} // namespace rigor
