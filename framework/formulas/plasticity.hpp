// SPDX-License-Identifier: MIT
// Topic `plasticity`, assignment A6: when a solid yields, and how it flows.
// Source: lecture "Rigid bodies", its first pages. They have the von Mises criterion, the von Mises
// stress of a linear elastic solid directly from its strain, and perfect plastic flow. Conventions:
// types.hpp. Stresses σ (in Pa) and strains ε (without unit) are symmetric; tension is positive. Tr
// is the trace, ‖·‖ the Frobenius norm, δ the identity.
#pragma once

#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"

namespace rigor {

/// A6.1 The deviator, the part of a stress that changes the shape but not the volume:
/// dev σ = σ - ⅓ Tr(σ) δ [Pa].
Matrix3d deviator(const Matrix3d& stress);

/// A6.2 The von Mises stress from the three principal stresses [Pa]:
///
///     1/√2 √((σ₁ - σ₂)² + (σ₂ - σ₃)² + (σ₃ - σ₁)²)
double von_mises_principal(double stress1, double stress2, double stress3);

/// A6.3 The von Mises stress from the stress itself, without its principal axes [Pa]:
/// √(3/2) √(‖σ‖² - ⅓ Tr(σ)²).
///
/// Under pure pressure the difference consists of rounding errors and may be negative; then the
/// result is 0.
double von_mises_frobenius(const Matrix3d& stress);

/// A6.4 The von Mises stress from the deviator [Pa]: √(3/2) ‖dev σ‖. Unlike in A6.3, no digits
/// cancel under a root.
double von_mises(const Matrix3d& stress);

/// A6.5 Stress of a linear, isotropic, elastic solid [Pa]: σ = λ Tr(ε) δ + 2 G ε.
///
/// @param strain         ε, elastic
/// @param lame_lambda    λ [Pa], negative in a solid that becomes wider when it is stretched
/// @param shear_modulus  G [Pa]
Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus);

/// A6.6 The von Mises stress of a solid as in A6.5, directly from its elastic strain [Pa]:
/// 2 G √(3/2) ‖dev ε‖. So the stress tensor is not needed to find out whether the solid yields.
double von_mises_from_strain(const Matrix3d& strain, double shear_modulus);

/// A6.7 The yield limit in terms of strain, σ_Y / (2 G): the solid yields where √(3/2) ‖dev ε‖
/// exceeds this limit. G ≥ 0 [Pa]; G = 0: infinity, since the solid never yields.
double yield_strain(double yield_stress, double shear_modulus);

/// A6.8 Associative perfect plasticity: the plastic strain after a time step.
///
///     f(σ) = √(3/2) ‖dev σ‖ - σ_Y
///     f ≤ 0:  ε_p stays as it is
///     f > 0:  ε_p ← ε_p + γ √(3/2) dev σ / ‖dev σ‖  with γ such that f = 0 for the new stress
///
/// The total strain stays the same, so the new stress is σ_new = σ - 2 G (ε_p_new - ε_p). Neither
/// the trace of ε_p nor the pressure changes.
///
/// @param plastic_strain  ε_p
/// @param stress          σ, caused by the elastic strain: the total strain minus ε_p [Pa]
/// @param yield_stress    σ_Y ≥ 0 [Pa]
/// @param shear_modulus   G ≥ 0 [Pa]; G = 0: ε_p stays as it is
Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus);

} // namespace rigor
