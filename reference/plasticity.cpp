// SPDX-License-Identifier: MIT
// Solutions of assignment A6: the von Mises stress and the plastic flow of a solid. The formulas
// are those of the lecture "Rigid bodies", in the order of the tasks.
#include "formulas/plasticity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

const double sqrt_3_2 = std::sqrt(1.5); // √(3/2)

} // namespace

Matrix3d deviator(const Matrix3d& stress)
{
    // dev σ = σ - ⅓ Tr(σ) δ
    return stress - stress.trace() / 3 * Matrix3d::Identity();
}

double von_mises_principal(double stress1, double stress2, double stress3)
{
    const Vector3d differences(stress1 - stress2, stress2 - stress3, stress3 - stress1);

    // 1/√2 √((σ₁ - σ₂)² + (σ₂ - σ₃)² + (σ₃ - σ₁)²)
    return 1 / std::sqrt(2.0) * differences.norm();
}

double von_mises_frobenius(const Matrix3d& stress)
{
    const double trace = stress.trace();

    // √(3/2) √(‖σ‖² - ⅓ Tr(σ)²)
    const double square = stress.squaredNorm() - trace * trace / 3;
    return sqrt_3_2 * std::sqrt(std::max(square, 0.0)); // negative only by rounding
}

double von_mises(const Matrix3d& stress)
{
    // √(3/2) ‖dev σ‖
    return sqrt_3_2 * deviator(stress).norm();
}

Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    // σ = λ Tr(ε) δ + 2 G ε
    return lame_lambda * strain.trace() * Matrix3d::Identity() + 2 * shear_modulus * strain;
}

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    // 2 G √(3/2) ‖dev ε‖
    return 2 * shear_modulus * sqrt_3_2 * deviator(strain).norm();
}

double yield_strain(double yield_stress, double shear_modulus)
{
    if (shear_modulus == 0) return std::numeric_limits<double>::infinity();

    // σ_Y / (2 G)
    return yield_stress / (2 * shear_modulus);
}

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    const Matrix3d s = deviator(stress);

    // f(σ) = √(3/2) ‖dev σ‖ - σ_Y
    const double f = sqrt_3_2 * s.norm() - yield_stress;
    if (f <= 0 || shear_modulus == 0) return plastic_strain; // elastic, or no stiffness

    // f(σ_new) = f(σ) - 3 G γ = 0
    const double gamma = f / (3 * shear_modulus);

    // ε_p + γ √(3/2) dev σ / ‖dev σ‖
    return plastic_strain + gamma * sqrt_3_2 * (s / s.norm());
}

} // namespace rigor
