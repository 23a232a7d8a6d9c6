// SPDX-License-Identifier: MIT
// Topic `plasticity`, assignment A6: when a solid yields, and how it flows.
// Source: lecture "Rigid bodies", its first pages: the von Mises criterion, the linear elasticity
// shortcut, perfect plastic flow. Conventions: types.hpp. Stresses σ in Pa and strains ε without unit
// are symmetric; tension is positive. Tr is the trace, ‖·‖ the Frobenius norm, δ the identity.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A6.1 The part of a stress that changes the shape, not the volume: dev σ = σ - ⅓ Tr(σ) δ [Pa].
Matrix3d deviator(const Matrix3d& stress);

/// A6.2 The von Mises stress from the three principal stresses [Pa]:
///
///     1/√2 √((σ₁ - σ₂)² + (σ₂ - σ₃)² + (σ₃ - σ₁)²)
double von_mises_principal(double stress1, double stress2, double stress3);

/// A6.3 The same from any stress, without its principal axes [Pa]: √(3/2) √(‖σ‖² - ⅓ Tr(σ)²).
///
/// Under pressure alone the difference is nothing but rounding, and may be negative: then 0.
double von_mises_frobenius(const Matrix3d& stress);

/// A6.4 The same from the deviator [Pa]: √(3/2) ‖dev σ‖. No digits cancel under a root.
double von_mises(const Matrix3d& stress);

/// A6.5 Stress of a linear, isotropic, elastic solid [Pa]: σ = λ Tr(ε) δ + 2 G ε.
///
/// @param strain         ε, elastic
/// @param lame_lambda    λ [Pa]
/// @param shear_modulus  G [Pa]
Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus);

/// A6.6 The von Mises stress of such a solid straight from its elastic strain [Pa]:
/// 2 G √(3/2) ‖dev ε‖. Where only yielding matters the stress itself need not be computed.
double von_mises_from_strain(const Matrix3d& strain, double shear_modulus);

/// A6.7 The yield stress scaled for strains: the solid yields where √(3/2) ‖dev ε‖ exceeds
/// σ_Y / (2 G). G = 0: infinity, as nothing ever yields.
double yield_strain(double yield_stress, double shear_modulus);

/// A6.8 Associative perfect plasticity: the plastic strain after a time step.
///
///     f(σ) = √(3/2) ‖dev σ‖ - σ_Y          f ≤ 0: ε_p stays as it is
///     ε_p ← ε_p + γ √(3/2) dev σ / ‖dev σ‖  with γ such that f = 0 for the new stress
///
/// The new stress is that of the same total strain: σ_new = σ - 2 G (ε_p_new - ε_p). So the trace of
/// ε_p does not change, and neither does the pressure.
///
/// @param plastic_strain  ε_p
/// @param stress          σ, of the total strain minus ε_p [Pa]
/// @param yield_stress    σ_Y ≥ 0 [Pa]
/// @param shear_modulus   G [Pa]; G = 0: ε_p stays as it is
Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus);

} // namespace rigor
