// SPDX-License-Identifier: MIT
// Assignment A6. Read: assignments/a6-plasticity/README.md, then framework/formulas/plasticity.hpp,
// which says what each function takes and returns, and what it does in special cases.
// Check: ./rigor check plasticity, or one task, ./rigor check A6.3
#include "formulas/plasticity.hpp"

namespace rigor {

// A6.1  dev σ = σ - ⅓ Tr(σ) δ
Matrix3d deviator(const Matrix3d& stress)
{
    throw NotImplemented("plasticity::deviator");
}

// A6.2  1/√2 √((σ₁ - σ₂)² + (σ₂ - σ₃)² + (σ₃ - σ₁)²)
double von_mises_principal(double stress1, double stress2, double stress3)
{
    throw NotImplemented("plasticity::von_mises_principal");
}

// A6.3  √(3/2) √(‖σ‖² - ⅓ Tr(σ)²), never NaN
double von_mises_frobenius(const Matrix3d& stress)
{
    throw NotImplemented("plasticity::von_mises_frobenius");
}

// A6.4  √(3/2) ‖dev σ‖
double von_mises(const Matrix3d& stress)
{
    throw NotImplemented("plasticity::von_mises");
}

// A6.5  σ = λ Tr(ε) δ + 2 G ε
Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    throw NotImplemented("plasticity::isotropic_stress");
}

// A6.6  2 G √(3/2) ‖dev ε‖
double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    throw NotImplemented("plasticity::von_mises_from_strain");
}

// A6.7  σ_Y / (2 G); G = 0: infinity
double yield_strain(double yield_stress, double shear_modulus)
{
    throw NotImplemented("plasticity::yield_strain");
}

// A6.8  ε_p + γ √(3/2) dev σ / ‖dev σ‖ where f(σ) > 0, with γ such that f(σ_new) = 0
Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    throw NotImplemented("plasticity::plastic_flow");
}

} // namespace rigor
