// SPDX-License-Identifier: MIT
// Topic `kinematics`, assignment A1: object space and world space, velocity modes, virtual work,
// equations of motion. Source: lecture "Rigid bodies". Conventions: types.hpp.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A1.1 The cross-product matrix w*: w* x = w × x for every x.
/// Lecture: "The cross-product matrix".
///
///          (   0  -w₂   w₁ )
///     w* = (  w₂    0  -w₀ )
///          ( -w₁   w₀    0 )
Matrix3d cross_matrix(const Vector3d& w);

/// A1.2 World-space position of an object-space point, x = R p + X [m].
/// Lecture: "Object space vs. world space".
Vector3d world_point(const Matrix3d& R, const Vector3d& X, const Vector3d& p);

/// A1.3 Object-space position of a world-space point, p = Rᵀ (x - X) [m].
/// Lecture: "Kinematics".
Vector3d object_point(const Matrix3d& R, const Vector3d& X, const Vector3d& x);

/// A1.4 Angular velocity ω [rad/s] of a rotating frame, from A = Ṙ Rᵀ, which is ω* if Ṙ is exact.
/// Lecture: "Skew-symmetry".
///
/// Rounding or finite differences may make A not exactly skew-symmetric. So ω is taken from its
/// skew part, ½ (A - Aᵀ).
///
/// @param R_dot  Ṙ [1/s]
Vector3d angular_velocity(const Matrix3d& R_dot, const Matrix3d& R);

/// A1.5 World-space velocity of the point of the body at x, v = ω × (x - X) + V [m/s].
Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x);

/// A1.6 Velocity modes: the 3×6 matrix S(x) = ( δ  X* - x* ), so that v(x) = S(x) (V, ω).
/// Lecture: "Velocity modes".
Matrix36d velocity_modes(const Vector3d& X, const Vector3d& x);

/// A1.7 Generalized mass, Sᵀ M S = Σ mᵢ S(xᵢ)ᵀ S(xᵢ), a 6×6 matrix.
/// Lecture: "Constrained dynamics", "Working it out".
///
/// X is the point to rotate about. It may be any point that moves with the body; V is then the
/// velocity of this point. The off-diagonal blocks are zero if and only if X is the center of mass.
/// Without particles, the result is zero.
///
/// @param particles  in world space
Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X);

/// A1.8 Net force F = Σ fᵢ and net torque τ = Σ (xᵢ - X) × fᵢ about X, which may be any point.
/// Lecture: "What about the external forces?".
///
/// F and τ together are the sum of S(xᵢ)ᵀ fᵢ, with S as in A1.6; its transpose turns X* - xᵢ* into
/// (xᵢ - X)*. No force: zero.
Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X);

/// A1.9 Equations of motion.
/// Lecture: "Equations of motion".
///
///     Ẋ = V    Ṙ = ω* R  with  ω = I(t)⁻¹ L    V̇ = F / M    L̇ = τ
///
/// Static body (inverse_mass = 0): every rate is zero, even if `state` has a velocity.
///
/// @param inverse_mass  1/M [1/kg]
/// @param I_inverse     I(t)⁻¹ in world space [1/(kg m²)]
MatrixStateRate equations_of_motion(const MatrixState& state, double inverse_mass,
                                    const Matrix3d& I_inverse, const Wrench& wrench);

/// A1.12 Rates of the velocity modes: the 3×6 matrix Ṡ = ( 0  V* - v* ) [1/s] of a particle at x
/// that moves with v. Lecture: "Change of S".
///
/// Ṡ appears in the equation of motion (Sᵀ M S) u̇ + (Sᵀ M Ṡ) u = Sᵀ F, with u = (V, ω).
Matrix36d velocity_mode_rates(const Vector3d& V, const Vector3d& v);

/// A1.13 The force and the torque Σ mᵢ Sᵢᵀ Ṡᵢ u, with u = (V, ω), of particles that move as one
/// rigid body: vᵢ = ω × (xᵢ - X) + V. Lecture: "Constrained dynamics", "Change of S".
///
/// X may be any point that moves with V. Only vᵢ - V enters, so the result does not depend on V,
/// apart from the rounding of vᵢ.
/// About the center of mass the force is 0 and the torque is ω × I ω. No particle: zero.
///
/// @param particles  in world space
Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d& V,
                       const Vector3d& omega);

} // namespace rigor
