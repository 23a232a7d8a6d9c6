// SPDX-License-Identifier: MIT
// Deformation, strain, stress and energy of one linear tetrahedron.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// F = ∂x/∂X of an element with its corners at the positions xᵢ, and at Xᵢ in the mesh at rest:
/// [x₁ - x₀, x₂ - x₀, x₃ - x₀] [X₁ - X₀, X₂ - X₀, X₃ - X₀]⁻¹.
Matrix3d deformation_gradient(const Deformable& solid, int element);

/// ε - ε_p, in the element's rest space: the total strain ε = S - δ minus the plastic strain ε_p.
/// Here F = R S is the polar decomposition of the deformation gradient, and δ the unit matrix.
Matrix3d elastic_strain(const Deformable& solid, int element);

/// The stress σ = λ Tr(e) δ + 2 G e of the elastic strain e = ε - ε_p, by `isotropic_stress` [Pa].
/// δ is the unit matrix.
Matrix3d stress_of(const Deformable& solid, int element);

/// The stress of each element (`stress_of`), in its rest space [Pa].
std::vector<Matrix3d> element_stresses(const Deformable& solid);

/// Elastic energy per volume at rest: ½ σ : e, with the stress σ and the elastic strain e [J/m³].
double energy_density(const Deformable& solid, int element);

/// Whether an element with the plastic strain ε_p and the elastic strain ε_e is inverted:
/// det (δ + ε_p + ε_e) ≤ 0, with the unit matrix δ.
bool is_inverted(const Matrix3d& plastic, const Matrix3d& elastic);

} // namespace rigor
