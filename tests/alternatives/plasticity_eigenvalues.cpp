// SPDX-License-Identifier: MIT
// Differences of entries, component sums in long double, and the radial return by a scale factor.
#include "formulas/plasticity.hpp"

#include <cmath>
#include <limits>

namespace rigor {

namespace {

// √(3/2) ‖dev A‖ from the differences between diagonal entries, and from the entries beside the
// diagonal.
double equivalent(const Matrix3d& A)
{
    long double square = 0;
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3;
        const long double difference = static_cast<long double>(A(i, i)) - A(k, k);
        square += difference * difference / 2;
        square += 3 * static_cast<long double>(A(i, k)) * A(k, i);
    }
    return static_cast<double>(std::sqrt(std::max(square, 0.0L)));
}

} // namespace

Matrix3d deviator(const Matrix3d& stress)
{
    Matrix3d s = stress;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        s(i, i) = ((stress(i, i) - stress(j, j)) + (stress(i, i) - stress(k, k))) / 3;
    }
    return s;
}

double von_mises_principal(double stress1, double stress2, double stress3)
{
    const long double a = static_cast<long double>(stress1) - stress2,
                      b = static_cast<long double>(stress2) - stress3;
    return static_cast<double>(std::sqrt(a * a + a * b + b * b));
}

double von_mises_frobenius(const Matrix3d& stress)
{
    double squares = 0;
    for (int i = 8; i >= 0; --i)
        squares = std::fma(stress(i), stress(i), squares);
    const double p = stress.trace();
    const double square = 1.5 * squares - 0.5 * p * p;
    return square > 0 ? std::sqrt(square) : 0;
}

double von_mises(const Matrix3d& stress)
{
    return equivalent(stress);
}

Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    // (3 λ + 2 G) times the mean strain, and 2 G times the rest
    const double mean = strain.trace() / 3;
    const Matrix3d rest = strain - mean * Matrix3d::Identity();
    return (3 * lame_lambda + 2 * shear_modulus) * mean * Matrix3d::Identity() +
           2 * shear_modulus * rest;
}

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    return std::abs(2 * shear_modulus) * equivalent(strain);
}

double yield_strain(double yield_stress, double shear_modulus)
{
    if (shear_modulus == 0) return std::numeric_limits<double>::infinity();
    return yield_stress / shear_modulus / 2;
}

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    // the deviator shrinks by the factor σ_Y / σ_vM; what it loses is 2 G Δε_p
    const double present = equivalent(stress);
    if (present <= yield_stress || shear_modulus == 0) return plastic_strain;
    const double lost = (present - yield_stress) / present;
    return plastic_strain + lost / (2 * shear_modulus) * deviator(stress);
}

} // namespace rigor
