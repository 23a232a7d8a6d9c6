// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/body.hpp"

namespace rigor {

/// The method for the rotation of a body on which no torque acts and whose three principal moments
/// differ: the series for the mean angular velocity Ω in `constant_wrench_step`, or the exact Ω of
/// free_rotation.hpp.
enum class FreeRotation { fourth_order, exact };

/// A step of fourth order under a wrench that is constant during the step: Buss's augmented
/// fourth-order method (Buss 2000, "Accurate and efficient simulation of rigid-body rotations", J.
/// Comput. Phys. 164). It extends `step_buss` (task A3.16) by two more derivatives of ω. With
/// J = I(t)⁻¹, and ω* the matrix with ω* x = ω × x:
///
///     ω = J L    ω̇ = J (τ - ω × L)    J̇ = ω* J - J ω*,  from which ω̈ and ω⃛ follow
///     Ω = ω + h/2 ω̇ + h²/6 ω̈ + h³/24 ω⃛ + h²/12 ω̇ × ω + h³/24 ω̈ × ω
///     q' = advance_exact(q, Ω, h)    L' = L + h τ    V' = V + h F/M    X' = X + h V + h²/2 F/M
///
/// The cross products appear because rotations do not commute (Magnus 1954, "On the exponential
/// solution of differential equations for a linear operator", Comm. Pure Appl. Math. 7). In
/// general, a step calls `to_matrix`, `world_inverse_inertia` and `advance_exact` once each. In a
/// measurement, this method had a third of the error of Munthe-Kaas's method (free_flight.hpp) and
/// took 0.4 of its time. `bench spin` compares this method with the other integrators. An isotropic
/// body without torque rotates exactly, by any angle; no rotation matrix is computed for it.
///
/// A body of revolution about the axis a, without torque, rotates exactly too: the body rotates
/// about a, while a rotates about L. With J = i δ + k a aᵀ, a in world space, and exp(v) the
/// rotation by the rotation vector v:
///
///     q' = exp(h i L) exp(h k (L·a) a) q
///
/// If `free_rotation` is `exact`, any other body without torque takes the exact Ω of
/// free_rotation.hpp, which costs more than the series for Ω above. But if |I⁻¹| |L| h is below
/// 1e-3, it still takes the series, because the error of the series is then below rounding errors.
RigidState constant_wrench_step(const RigidBody& body, const RigidState& state,
                                const Wrench& wrench, double time_step,
                                FreeRotation free_rotation = FreeRotation::fourth_order);

} // namespace rigor
