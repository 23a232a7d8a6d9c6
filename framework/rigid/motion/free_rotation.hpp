// SPDX-License-Identifier: MIT
// The exact rotation of a body that no torque acts on.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// A constant angular velocity Ω that gives the same rotation over a time h as the free motion of
/// the body. Ω is given in the principal frame that the body has at the start of this time [rad/s].
///
/// The angular momentum M in the body follows Euler's equations, which Jacobi solved (1849; Landau
/// and Lifshitz, "Mechanics", § 37). The inverse moments J are numbered so that J₁ > J₂ > J₃ or
/// J₁ < J₂ < J₃, whichever makes M circle about axis 3:
///
///     M₁ = A₁ cn u    M₂ = A₂ sn u    M₃ = A₃ dn u    u̇ = ±√((J₂ - J₃) r)
///
/// with amplitudes A that the energy and |M| give, and r = (J₁ - J₂) M₂² + (J₁ - J₃) M₃², which is
/// constant. In world space the angular momentum L is constant, and axis 3 turns about it by an
/// angle φ. Van Zon and Schofield (2007, "Numerical implementation of the exact dynamics of free
/// rigid bodies", J. Comput. Phys. 225) compute φ by a theta series; this function computes φ by
/// Carlson's integrals (`carlson_rj`):
///
///     φ̇ = |L| (J₂ + (J₁ - J₂) M₁² / (M₁² + M₂²))
///
/// The error is no larger than the error that rounding of the arguments causes, for a time of any
/// length and for moments that are equal, nearly equal or far apart.
///
/// @param inverse_moments  J, in any order [1/(kg m²)]
/// @param momentum         M, the angular momentum along the principal axes [kg m²/s]
/// @param time             h, not 0 [s]
Vector3d mean_free_angular_velocity(const Vector3d& inverse_moments, const Vector3d& momentum,
                                    double time);

} // namespace rigor
