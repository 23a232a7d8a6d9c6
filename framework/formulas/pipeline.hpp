// SPDX-License-Identifier: MIT
// Topic `pipeline`, assignment A0: one line of mathematics, to learn how to build the project, see
// a test fail, read its message, fix the code and see the test pass. Conventions: types.hpp.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A0.1 Kinetic energy of a rigid body [J].
///
///     E = ½ M V·V + ½ ω·I ω
///
/// @param mass              M [kg]
/// @param velocity          V of the center of mass [m/s]
/// @param inertia           I about the center of mass, in the frame of ω [kg m²]
/// @param angular_velocity  ω [rad/s]
double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity);

} // namespace rigor
