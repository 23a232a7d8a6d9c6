// SPDX-License-Identifier: MIT
// Topic `collision`, assignment A4: level sets, collision impulses, friction.
// Source: lecture "Inertia, rotation, impulses". Conventions: types.hpp. Everything is in world
// space; n is unit and points from body 2 to body 1; v = v1 - v2; body 1 receives +j, body 2 -j. ε
// is restitution, μ friction, K = K₁ + K₂.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A4.1 Signed distance φ(p) [m], trilinear between the nodes of the grid's cell that holds p;
/// negative inside.
///
/// Outside the grid: the value at the nearest point of the grid's box, plus the distance to that
/// point.
///
/// @param grid  at least 2 nodes along each axis
double sample_level_set(const LevelSet& grid, const Vector3d& p);

/// A4.2 Outward unit normal at p: the normalized gradient of the trilinear φ in the cell that holds
/// p.
///
/// A point on a face between two cells belongs to the higher one; the last node's face to the last
/// cell. Outside the grid: that gradient at the nearest point of its box. Zero gradient: (0, 1, 0).
Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p);

/// A4.3 Relative velocity at x, v = v₁ - v₂ with vᵢ = ωᵢ × (x - Xᵢ) + Vᵢ [m/s].
/// Lecture: "Frictionless impulse".
Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x);

/// A4.4 Impulse matrix K = δ/M + (x - X)*ᵀ I⁻¹ (x - X)* [1/kg]: an impulse j at x changes the
/// velocity of x by K j.
///
/// Static body (inverse_mass = 0): zero.
Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x);

/// A4.5 Frictionless impulse j = -(1 + ε) vₙ / (nᵀ K n) n [N s].
/// Lecture: "Computing frictionless impulse".
///
/// Both bodies static (nᵀ K n = 0): zero.
Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution);

/// A4.6 Impulse that stops all tangential motion, j = K⁻¹ (-v - ε vₙ n).
/// Lecture: "Computing static friction".
///
/// K is symmetric positive definite unless both bodies are static (K = 0): zero.
Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution);

/// A4.7 Whether j lies in the friction cone, |j_T| ≤ μ jₙ, and pushes, jₙ ≥ 0.
/// Lecture: "Computing friction".
bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction);

/// A4.8 Sliding impulse, its tangential part against the initial sliding.
/// Lecture: "Computing sliding friction".
///
///     T = (v - vₙ n)/|v - vₙ n|    jₙ = -(1 + ε) vₙ / (nᵀ K (n - μ T))    j = jₙ n - μ jₙ T
///
/// No tangential velocity (|v - vₙ n| ≤ 1e-12 |v|: what rounding left has no direction): the
/// frictionless impulse. Both bodies static: zero. nᵀ K (n - μ T) ≤ 0, where friction jams the
/// contact: the static impulse, its tangential part j_T shortened to |j_T| = μ jₙ where it is longer
/// (zero if that pulls).
Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction);

/// A4.9 The impulse of a collision: separating (vₙ ≥ 0), zero; else the static one if it lies in
/// the friction cone; else the sliding one.
/// Lecture: "Computing friction".
Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction);

/// A4.10 The body after the impulse j at x: V += j/M, L += (x - X) × j, ω += I⁻¹ (x - X) × j.
///
/// For body 2 pass -j. Static body: unchanged.
Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j);

/// A4.11 Index of the deepest contact whose bodies still approach there, v·n < 0.
/// Lecture: "Rigid collision algorithms".
///
/// None: empty. Equal depths: the first of them.
std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts);

} // namespace rigor
