// SPDX-License-Identifier: MIT
// Topic `rotation`, assignment A3: drift of rotation matrices, Euler angles, quaternions, time
// integration, gravity.
// Source: lecture "Inertia, rotation, impulses". Conventions: types.hpp. Angular velocities are in
// world space.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A3.1 R + Δt ω* R, the naive update.
/// Lecture: "Numerical integration".
///
/// The result drifts away from a rotation. The function is here to show this.
Matrix3d advance_matrix(const Matrix3d& R, const Vector3d& omega, double time_step);

/// A3.2 Gram–Schmidt on the columns of R, from the first to the last. It is expensive, and biased
/// towards the first column; the function is here to show this.
///
/// The first column keeps its direction, the second loses its part along the first, and the third
/// follows from both, so the result is a rotation (orthonormal, det +1). If a column is zero or
/// linearly dependent on those before it, any completion to a rotation is correct.
Matrix3d gram_schmidt(const Matrix3d& R);

/// A3.3 Rotation matrix of Euler angles (φ, θ, ψ): R = R_z(ψ) R_y(θ) R_x(φ). The
/// rotation about x comes first.
///
/// @param angles  (φ, θ, ψ): roll about x, pitch about y, yaw about z [rad]
Matrix3d euler_to_matrix(const Vector3d& angles);

/// A3.4 Rates (φ̇, θ̇, ψ̇) [rad/s] of the Euler angles (φ, θ, ψ) of A3.3, if the angular velocity
/// in world space is ω.
///
///     ω = ψ̇ e_z + R_z(ψ) (θ̇ e_y + R_y(θ) φ̇ e_x)
///
/// At gimbal lock, |cos θ| < 1e-12, the rates do not exist and the result is empty.
std::optional<Vector3d> euler_rates(const Vector3d& angles, const Vector3d& omega);

/// A3.5 Quaternion product a b = (s_a s_b - v_a·v_b,  s_a v_b + s_b v_a + v_a × v_b). It does not
/// commute.
Quaternion multiply(const Quaternion& a, const Quaternion& b);

/// A3.6 Conjugate q̄ = (s, -v), the inverse of a unit quaternion.
Quaternion conjugate(const Quaternion& q);

/// A3.7 q / |q|. The zero quaternion gives the identity. The sign of q is kept. No square
/// underflows or overflows, however small or large q is.
Quaternion normalize(const Quaternion& q);

/// A3.8 Rotated vector, q (0, p) q̄.
/// Lecture: "Rotating with quaternions".
///
/// @param q  unit
Vector3d rotate(const Quaternion& q, const Vector3d& p);

/// A3.9 Rotation matrix of a unit quaternion; its columns are the rotated axes.
/// Lecture: "Converting q to R".
Matrix3d to_matrix(const Quaternion& q);

/// A3.10 q̇ = ½ (0, ω) q [1/s].
/// Lecture: "Rotating with quaternions".
Quaternion quaternion_rate(const Quaternion& q, const Vector3d& omega);

/// A3.11 Exact update for constant ω: (cos(Δt |ω|/2), sin(Δt |ω|/2) ω/|ω|) q.
///
/// A negative Δt turns back: the engine's method for springs takes such steps.
/// As ω → 0 the result goes smoothly to q, without 0/0, also for denormal numbers.
Quaternion advance_exact(const Quaternion& q, const Vector3d& omega, double time_step);

/// A3.12 Linear update, q + Δt/2 (0, ω) q, renormalized. About a fixed axis it turns by
/// 2 atan(|ω|Δt/2).
Quaternion advance_linear(const Quaternion& q, const Vector3d& omega, double time_step);

/// A3.13 Longest time step [s] in which the body turns by at most a quarter turn, (π/2)/|ω|.
/// Lecture: "Integrating rotation".
///
/// ω = 0, or so small that the quotient is no double: infinity, an exception to the rule that
/// results are finite.
double max_time_step(const Vector3d& omega);

/// A3.14 Gravity on a rigid body: the force M g and no torque.
/// Lecture: "Gravity".
///
/// @param gravity  g [m/s²]
Wrench gravity_wrench(double mass, const Vector3d& gravity);

/// A3.15 One step of symplectic Euler.
/// Lecture: "Integrating rotation".
///
///     V' = V + Δt F/M    X' = X + Δt V'    L' = L + Δt τ    q' = advance_linear(q, ω, Δt)
///
/// with ω = R(q) I_body⁻¹ R(q)ᵀ L', from the new L and the old q. Static body: unchanged.
///
/// @param wrench  in world space, constant over the step
RigidState step_symplectic_euler(const RigidState& state, const BodyInertia& body,
                                 const Wrench& wrench, double time_step);

/// A3.16 One step of Buss's augmented second-order method (Buss 2000, "Accurate and efficient
/// simulation of rigid-body rotations", J. Comput. Phys. 164).
///
///     V' = V + Δt F/M                   X' = X + Δt V + ½ Δt² F/M
///     ω  = I⁻¹ L                        ω̇  = I⁻¹ (τ - ω × L)        I⁻¹ = R(q) I_body⁻¹ R(q)ᵀ
///     Ω  = ω + Δt/2 ω̇ + Δt²/12 (ω̇ × ω)  q' = advance_exact(q, Ω, Δt)  L' = L + Δt τ
///
/// The last term of Ω appears in third-order methods, because rotations do not commute. Compared
/// with such a method, only the term Δt²/6 ω̈ of Ω is omitted. If the last term of Ω has the wrong
/// sign, the order is still 2, so only the size of the error shows the mistake. Static body:
/// unchanged.
RigidState step_buss(const RigidState& state, const BodyInertia& body, const Wrench& wrench,
                     double time_step);

} // namespace rigor
