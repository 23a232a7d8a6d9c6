// SPDX-License-Identifier: MIT
// From the parts of a body to its mass, inertia and inverse inertia: once a body, never in a step.
#pragma once

#include "rigid/bodies/world.hpp"

namespace rigor {

/// Mass properties of parts, each of its own density, in the frame they are written in.
///
/// Calls the formula of each part's shape (a cone and a torus have none: theirs is the closed form),
/// `world_inertia` only for a part whose inertia a rotation changes, and `combine` only for a capsule
/// and for several parts.
MassProperties mass_properties(const std::vector<Part>& parts);

/// Whether I = i δ, to 64 roundings: cubes and spheres are, however they are turned. Zero is.
bool is_isotropic(const Matrix3d& inertia);

/// Gives a body its mass from its parts' densities, and moves the parts so that object space has its
/// origin at the center of mass. A static body is left alone: its origin stays.
///
/// @return  the center of mass in the frame the parts were written in [m]
/// @throws NonFiniteState if a formula did not return a number
Vector3d set_mass_from_parts(RigidBody& body);

/// Gives a body this mass and inertia about the origin of object space, its center of mass, and what
/// follows from them: 1/M, I_body⁻¹ through its principal axes, and how far it is symmetric.
///
/// @throws NonFiniteState if a formula did not return a number
void set_mass(RigidBody& body, double mass, const Matrix3d& inertia);

} // namespace rigor
