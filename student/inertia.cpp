// SPDX-License-Identifier: MIT
// Assignment A2. Read: assignments/a2-inertia/README.md, then framework/formulas/inertia.hpp,
// which says what each function takes and returns, and what it does in special cases.
// Check: ./rigor check inertia, or one task, ./rigor check A2.4
#include "formulas/inertia.hpp"

namespace rigor {

// A2.1  M = Σ mᵢ    X = Σ mᵢ pᵢ / M    I = Σ mᵢ (dᵢᵀdᵢ δ - dᵢ dᵢᵀ),  dᵢ = pᵢ - X
MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    throw NotImplemented("inertia::particle_mass_properties");
}

// A2.2  I(t) = R I_body Rᵀ
Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    throw NotImplemented("inertia::world_inertia");
}

// A2.3  I(t)⁻¹ = R I_body⁻¹ Rᵀ
Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I_body_inverse)
{
    throw NotImplemented("inertia::world_inverse_inertia");
}

// A2.4  I = Q diag(moments) Qᵀ, Q a rotation, moments ascending and never negative
PrincipalAxes principal_axes(const Matrix3d& I)
{
    throw NotImplemented("inertia::principal_axes");
}

// A2.5  1/Jᵢ, but 0 where Jᵢ ≤ 1e-12 max(J)
Vector3d invert_moments(const Vector3d& moments)
{
    throw NotImplemented("inertia::invert_moments");
}

// A2.6  M = ρ 4/3 π r³    I = 2/5 M r² δ
MassProperties solid_sphere(double density, double radius)
{
    throw NotImplemented("inertia::solid_sphere");
}

// A2.7  M = ρ a b c    Ixx = M/12 (b² + c²), and so on
MassProperties solid_box(double density, const Vector3d& size)
{
    throw NotImplemented("inertia::solid_box");
}

// A2.8  M = ρ π r² l    Iyy = ½ M r²    Ixx = Izz = M/12 (3 r² + l²)
MassProperties solid_cylinder(double density, double radius, double height)
{
    throw NotImplemented("inertia::solid_cylinder");
}

// A2.9  M = ρ 4/3 π a b c    Ixx = M/5 (b² + c²), and so on
MassProperties solid_ellipsoid(double density, const Vector3d& radii)
{
    throw NotImplemented("inertia::solid_ellipsoid");
}

// A2.10  M = λ l    Ixx = Izz = M l²/12    Iyy = 0
MassProperties thin_rod(double line_density, double length)
{
    throw NotImplemented("inertia::thin_rod");
}

// A2.11  point masses mᵢ = ρᵢ h³
MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    throw NotImplemented("inertia::grid_mass_properties");
}

// A2.12  point masses mᵢ = ρᵢ V/N
MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    throw NotImplemented("inertia::sampled_mass_properties");
}

// A2.13  M = ρ ∫ dV    X = ρ/M ∫ x dV    I = ρ ∫ (dᵀd δ - d dᵀ) dV,  d = x - X
MassProperties mesh_mass_properties(const TriangleMesh& mesh, double density)
{
    throw NotImplemented("inertia::mesh_mass_properties");
}

// A2.14  M = M₁ + M₂    X = (M₁ X₁ + M₂ X₂) / M    I = Σ Iᵢ + Mᵢ (Xᵢ - X)*ᵀ (Xᵢ - X)*
MassProperties combine(const MassProperties& a, const MassProperties& b)
{
    throw NotImplemented("inertia::combine");
}

// A2.17  the box that bounds the vertices, with the given mass
MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    throw NotImplemented("inertia::bounding_box_mass_properties");
}

} // namespace rigor
