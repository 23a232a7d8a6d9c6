// SPDX-License-Identifier: MIT
// Topic `inertia`, assignment A2: the inertia tensor simplified, degenerate, computed,
// approximated, combined. Source: lecture "Inertia, rotation, impulses". Conventions: types.hpp.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A2.1 Mass, center of mass and inertia of point masses.
/// Lecture: "Inertia tensor simplified".
///
///     M = Σ mᵢ    X = Σ mᵢ pᵢ / M    I = Σ mᵢ (dᵢᵀdᵢ δ - dᵢ dᵢᵀ),  dᵢ = pᵢ - X
///
/// No mass: all zero, center at the origin.
MassProperties particle_mass_properties(const std::vector<Particle>& particles);

/// A2.2 Inertia in world space, I(t) = R I_body Rᵀ [kg m²].
/// Lecture: "Inertia tensor simplified 2".
Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body);

/// A2.3 Inverse inertia in world space, I(t)⁻¹ = R I_body⁻¹ Rᵀ [1/(kg m²)], from the inverse
/// computed once.
Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse);

/// A2.4 Principal axes: a rotation Q (det +1) and ascending moments with I = Q diag(moments) Qᵀ.
///
/// Moments that rounding made negative become 0. Repeated moments: any rotation that satisfies the
/// equation.
///
/// @param I  symmetric, positive semi-definite [kg m²]
PrincipalAxes principal_axes(const Matrix3d& I);

/// A2.5 Inverse of principal moments, 1/mᵢ, but 0 where mᵢ is 0.
/// Lecture: "Degenerate inertia tensors".
///
/// A rod cannot be seen to turn about its own axis, nor a point about any: there the answer is 0. A
/// moment counts as 0 when mᵢ ≤ 1e-12 max(m), so that rounding is not inverted. All zero: zero.
///
/// @param moments  each ≥ 0 [kg m²]
Vector3d invert_moments(const Vector3d& moments);

/// A2.6 A solid sphere about its center: M = ρ 4/3 π r³, I = 2/5 M r² δ.
///
/// The size of a solid may be 0: then mass and inertia are 0. So for A2.7 to A2.10.
///
/// @param density  ρ [kg/m³]
/// @param radius   r ≥ 0 [m]
MassProperties solid_sphere(double density, double radius);

/// A2.7 A solid box about its center, edges (a, b, c) along the axes: M = ρ a b c,
/// Ixx = M/12 (b² + c²), and so on.
///
/// @param size  full edge lengths, each ≥ 0 [m]
MassProperties solid_box(double density, const Vector3d& size);

/// A2.8 A solid cylinder about its center, its axis along y:
/// M = ρ π r² h, Iyy = ½ M r², Ixx = Izz = M/12 (3 r² + h²).
MassProperties solid_cylinder(double density, double radius, double height);

/// A2.9 A solid ellipsoid about its center, semi-axes (a, b, c): M = ρ 4/3 π a b c,
/// Ixx = M/5 (b² + c²), and so on.
///
/// @param radii  semi-axes, each ≥ 0 [m]
MassProperties solid_ellipsoid(double density, const Vector3d& radii);

/// A2.10 A thin rod about its center, along y: M = λ l, Ixx = Izz = M l²/12, Iyy = 0.
///
/// @param line_density  λ [kg/m]
MassProperties thin_rod(double line_density, double length);

/// A2.11 Grid approach: each cell as a point mass m = ρ h³ at its center.
/// Lecture: "Approximating inertia tensors".
///
/// The error falls as h². For a cube of edge a with n cells an edge, I is M a²/6 (1 - 1/n²)
/// instead of M a²/6. No sample, or no mass: all zero.
///
/// @param samples    the density at the centers of the cells
/// @param cell_size  h [m]
MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size);

/// A2.12 Monte Carlo approach: N random samples, uniform in a region of known volume; each stands
/// for V/N of it.
///
/// The error falls as N^(-½). No sample, or no mass: all zero.
///
/// @param volume  V of the region the samples were drawn from [m³]
MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume);

/// A2.13 The solid enclosed by a triangle mesh, exactly.
///
///     M = ρ ∫ dV    X = ρ/M ∫ x dV    I = ρ ∫ (dᵀd δ - d dᵀ) dV,  d = x - X
///
/// Each triangle spans a signed tetrahedron with the origin; or the divergence theorem turns the
/// integrals into sums over the surface (Mirtich 1996, "Fast and accurate computation of polyhedral
/// mass properties"). Open mesh: what the sum over its triangles gives. No volume: all zero.
///
/// @param density  ρ [kg/m³]
MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density);

/// A2.14 The union of two bodies, in one frame: both moved to the common center.
/// Lecture: "Combined inertia tensor".
///
///     M = M₁ + M₂    X = (M₁ X₁ + M₂ X₂) / M    I = Σ Iᵢ + Mᵢ (Xᵢ - X)*ᵀ (Xᵢ - X)*
///
/// and never I₁ + I₂. One of zero mass: the other one. Both: all zero.
MassProperties combine(const MassProperties& a, const MassProperties& b);

} // namespace rigor
