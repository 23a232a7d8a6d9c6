// SPDX-License-Identifier: MIT
// Topic `collision`, assignment A4: level sets, collision impulses, friction.
// Source: lecture "Inertia, rotation, impulses". Conventions: types.hpp. In A4.1 and A4.2, points
// and normals are in the frame of the grid; everything else is in world space. n is unit and points
// from body 2 to body 1; v = v1 - v2; body 1 receives +j, body 2 receives -j. K = K₁ + K₂ is the
// sum of both bodies' matrices of A4.4. ε is the restitution: 1 reverses vₙ, 0 removes all of vₙ,
// -1 leaves vₙ as it is (in A5, -1 < ε ≤ 0). μ ≥ 0 is the friction coefficient.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A4.1 Signed distance φ(p) [m], negative inside: trilinear interpolation between the nodes of the
/// grid cell that contains p.
///
/// A point on the last face of the grid belongs to the last cell. Outside the grid: the value at
/// the nearest point of the grid's box, plus the distance to that point.
///
/// @param grid  at least 2 nodes along each axis
double sample_level_set(const LevelSet& grid, const Vector3d& p);

/// A4.2 Outward unit normal at p: the normalized gradient of the trilinear φ in the cell that
/// contains p.
///
/// A point on the face between two cells belongs to the cell with the higher index (where origin
/// and cell_size are not exact, as 0.1, rounding may decide); a point on the last face of the grid
/// belongs to the last cell. Outside the grid: the gradient at the nearest point of the grid's box.
/// Zero gradient: (0, 1, 0).
Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p);

/// A4.3 Relative velocity at x, v = v₁ - v₂ with vᵢ = ωᵢ × (x - Xᵢ) + Vᵢ [m/s]. A static body may
/// have a velocity, like the belt of a conveyor.
/// Lecture: "Frictionless impulse".
Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x);

/// A4.4 Impulse matrix K = δ/M + (x - X)*ᵀ I⁻¹ (x - X)* [1/kg]: an impulse j at x changes the
/// velocity of the body's point at x by K j.
///
/// Static body (inverse_mass = 0): zero.
Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x);

/// A4.5 Frictionless impulse j = -(1 + ε) vₙ / (nᵀ K n) n [N s]. Like A4.6 and A4.8 it does not ask
/// whether the bodies approach.
/// Lecture: "Computing frictionless impulse".
///
/// The formula also holds for bodies that separate: then the impulse pulls them together. (A4.9
/// gives no impulse to such bodies.) Both bodies static (nᵀ K n = 0): zero.
Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution);

/// A4.6 Sticking impulse, which stops all tangential motion, j = K⁻¹ (-v - ε vₙ n).
/// Lecture: "Computing static friction".
///
/// Like A4.5 it also holds for bodies that separate. Both bodies static (K = 0): zero. In all other
/// cases K is symmetric positive definite.
Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution);

/// A4.7 Whether j lies in the friction cone, |j_T| ≤ μ jₙ, and pushes the bodies apart, jₙ ≥ 0.
/// Lecture: "Computing friction".
bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction);

/// A4.8 Sliding impulse, with its tangential part opposite to the initial sliding velocity.
/// Lecture: "Computing sliding friction".
///
///     T = (v - vₙ n)/|v - vₙ n|    jₙ = -(1 + ε) vₙ / (nᵀ K (n - μ T))    j = jₙ n - μ jₙ T
///
/// Special cases:
///   * No tangential velocity, |v - vₙ n| ≤ 1e-12 |v|: the frictionless impulse, since such a
///     small v - vₙ n is a rounding error, whose direction means nothing.
///   * Both bodies static: zero.
///   * nᵀ K (n - μ T) ≤ 0, the contact jams: the sticking impulse of A4.6, with its tangential part
///     j_T shortened to |j_T| = μ jₙ if it is longer (zero if the sticking impulse pulls, jₙ ≤ 0).
Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction);

/// A4.9 The impulse of a collision. If the bodies separate (vₙ ≥ 0) it is zero; otherwise it is the
/// sticking impulse if that lies in the friction cone, and else the sliding impulse.
/// Lecture: "Computing friction".
Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction);

/// A4.10 The body after the impulse j at x: V += j/M, L += (x - X) × j, ω += I⁻¹ (x - X) × j.
///
/// For body 2 pass -j. Static body: unchanged.
Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j);

/// A4.11 Index of the deepest contact among those whose bodies still approach, v·n < 0.
/// Lecture: "Rigid collision algorithms".
///
/// The depth may also be 0, or negative where the bodies do not touch yet. No contact whose bodies
/// approach: empty. Equal depths: the first of these contacts.
std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts);

} // namespace rigor
