// SPDX-License-Identifier: MIT
// One linear tetrahedron: how it is deformed, and what that costs.
#pragma once

#include "deformable/deformable.hpp"

namespace rigor {

/// F = R S, with R a rotation and S symmetric. Where F is inverted S has a negative eigenvalue, the
/// smallest in size.
struct Polar {
    Matrix3d R = Matrix3d::Identity(), S = Matrix3d::Identity();
};

/// The polar decomposition of any F: R is the rotation with the largest Tr(Rᵀ F).
Polar polar_decomposition(const Matrix3d& F);

/// F = ∂x/∂X of an element: [x₁ - x₀, x₂ - x₀, x₃ - x₀] [X₁ - X₀, X₂ - X₀, X₃ - X₀]⁻¹.
Matrix3d deformation_gradient(const Deformable& solid, int element);

/// ε - ε_p, ε = S - δ, in the element's rest space.
Matrix3d elastic_strain(const Deformable& solid, int element);

/// σ = λ Tr(ε - ε_p) δ + 2 G (ε - ε_p), by `isotropic_stress` [Pa].
Matrix3d stress_of(const Deformable& solid, int element);

/// ½ σ : (ε - ε_p) [J/m³]
double energy_density(const Deformable& solid, int element);

} // namespace rigor
