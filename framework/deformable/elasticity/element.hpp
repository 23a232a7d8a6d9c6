// SPDX-License-Identifier: MIT
// Deformation, strain, stress and energy of one linear tetrahedron.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// F = ∂x/∂X of an element with its corners at the positions xᵢ, and at Xᵢ in the mesh at rest:
/// [x₁ - x₀, x₂ - x₀, x₃ - x₀] [X₁ - X₀, X₂ - X₀, X₃ - X₀]⁻¹.
Matrix3d deformation_gradient(const Deformable& solid, int element);

/// ε - ε_p with ε = S - δ, where F = R S and δ is the unit matrix; in the element's rest space.
Matrix3d elastic_strain(const Deformable& solid, int element);

/// σ = λ Tr(ε - ε_p) δ + 2 G (ε - ε_p), by `isotropic_stress` [Pa].
Matrix3d stress_of(const Deformable& solid, int element);

/// The stress of each element (`stress_of`), in its rest space [Pa].
std::vector<Matrix3d> element_stresses(const Deformable& solid);

/// Elastic energy per volume at rest: ½ σ : (ε - ε_p) [J/m³].
double energy_density(const Deformable& solid, int element);

/// Whether an element with these plastic and elastic strains is inverted: det (δ + ε_p + ε_e) ≤ 0.
bool is_inverted(const Matrix3d& plastic, const Matrix3d& elastic);

} // namespace rigor
