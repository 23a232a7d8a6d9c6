// SPDX-License-Identifier: MIT
// Topic `inertia`, assignment A2: the inertia tensors of point masses and of solids, their form in
// world space, degenerate tensors, approximations, and the tensor of two bodies together. Source:
// lecture "Inertia, rotation, impulses". Conventions: types.hpp.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A2.1 Mass, center of mass and inertia of point masses.
/// Lecture: "Inertia tensor simplified".
///
///     M = Σ mᵢ    X = Σ mᵢ pᵢ / M    I = Σ mᵢ (dᵢᵀdᵢ δ - dᵢ dᵢᵀ),  dᵢ = pᵢ - X
///
/// No mass: all results are zero, with the center at the origin.
MassProperties particle_mass_properties(const std::vector<Particle>& particles);

/// A2.2 Inertia in world space, I(t) = R I_body Rᵀ [kg m²].
/// Lecture: "Inertia tensor simplified 2".
Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body);

/// A2.3 Inverse inertia in world space, I(t)⁻¹ = R I_body⁻¹ Rᵀ [1/(kg m²)]. The caller computes
/// I_body⁻¹ once for each body; this function inverts no matrix.
Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse);

/// A2.4 Principal axes: a rotation Q (det +1) and ascending moments J with I = Q diag(J) Qᵀ.
///
/// Moments that are negative because of rounding become 0. If moments are repeated, any rotation
/// that satisfies the equation is correct.
///
/// @param I  symmetric, positive semi-definite [kg m²]
PrincipalAxes principal_axes(const Matrix3d& I);

/// A2.5 Inverse of principal moments, 1/Jᵢ, but 0 where Jᵢ is 0.
/// Lecture: "Degenerate inertia tensors".
///
/// The rotation of a thin rod about its own axis, or of a point about any axis, has no effect; the
/// result for such an axis is 0. A moment counts as 0 if Jᵢ ≤ 1e-12 max(J), so that rounding errors
/// are not inverted. If all moments are zero, the result is zero.
///
/// @param moments  J, each ≥ 0 [kg m²]
Vector3d invert_moments(const Vector3d& moments);

/// A2.6 A solid sphere about its center: M = ρ 4/3 π r³, I = 2/5 M r² δ.
///
/// The size of a solid may be 0; then its mass and inertia are 0. A hole has a negative density,
/// and so a negative mass and inertia. Both also hold for A2.7 to A2.10.
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
/// M = ρ π r² l, Iyy = ½ M r², Ixx = Izz = M/12 (3 r² + l²).
///
/// @param height  l ≥ 0 [m]
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

/// A2.11 Grid approach: each cell is a point mass m = ρ h³ at its center.
/// Lecture: "Approximating inertia tensors".
///
/// The error decreases as h². For a cube with edge length a and n cells along each edge, I is
/// M a²/6 (1 - 1/n²) instead of M a²/6. No sample, or no mass: all results are zero.
///
/// @param samples    the density at the centers of the cells
/// @param cell_size  h [m]
MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size);

/// A2.12 Monte Carlo approach: N random samples, uniform in a region of known volume V. Each sample
/// represents the volume V/N.
///
/// The error decreases as N^(-½). No sample, or no mass: all results are zero.
///
/// @param volume  V of the region the samples were drawn from [m³]
MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume);

/// A2.13 Exact mass properties of the solid enclosed by a triangle mesh.
///
///     M = ρ ∫ dV    X = ρ/M ∫ x dV    I = ρ ∫ (dᵀd δ - d dᵀ) dV,  d = x - X
///
/// One method sums over the signed tetrahedra that the triangles form with the origin; another one
/// uses the divergence theorem, which turns the integrals into sums over the surface (Mirtich 1996,
/// "Fast and accurate computation of polyhedral mass properties"). Open mesh: any finite result is
/// correct. Mesh inside out: mass and inertia change their sign, the center does not. A triangle
/// without area counts for nothing. No volume, or density 0: all results are zero. If only rounding
/// makes a volume, as that of a flat mesh that is tilted, any finite result is correct.
///
/// @param density  ρ [kg/m³]
MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density);

/// A2.14 Mass properties of the union of two bodies, given in the same frame. The inertia of both
/// is moved to the common center of mass.
/// Lecture: "Combined inertia tensor".
///
///     M = M₁ + M₂    X = (M₁ X₁ + M₂ X₂) / M    I = Σ Iᵢ + Mᵢ (Xᵢ - X)*ᵀ (Xᵢ - X)*
///
/// The sum I₁ + I₂ alone would be wrong. If one body has zero mass, the result is the other body.
/// If both do, all results are zero. A mass may be negative: a hole, or a mesh inside out. If two
/// masses m and -m ≠ 0 add up to 0, there is no center of mass, and any result is correct.
MassProperties combine(const MassProperties& a, const MassProperties& b);

/// A2.17 Approximation by a simpler shape: mass properties of a solid box that bounds the vertices,
/// its edges along the axes of the frame. The given mass is spread evenly over the box.
/// Lecture: "Approximating inertia tensors".
///
/// No vertex, or no mass: all results are zero. The box may be flat.
///
/// @param vertices  of the body, in any order
/// @param mass      M ≥ 0 [kg]
MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass);

} // namespace rigor
