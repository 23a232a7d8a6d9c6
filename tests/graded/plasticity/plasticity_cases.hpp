// SPDX-License-Identifier: MIT
// Stresses and strains, and the steel for which the tests know exact answers.
#pragma once

#include "support/close.hpp"
#include "support/random.hpp"

#include <cmath>

namespace rigor::testing {

/// The constants of a steel.
namespace steel {
inline constexpr double E = 200e9, nu = 0.3;    // Young's modulus [Pa], Poisson's ratio
inline constexpr double yield_stress = 250e6;   // [Pa]
inline constexpr double G = E / (2 * (1 + nu)); // shear modulus [Pa]
inline constexpr double lambda = E * nu / ((1 + nu) * (1 - 2 * nu)); // [Pa]
inline constexpr double bulk_modulus = E / (3 * (1 - 2 * nu));       // [Pa]
} // namespace steel

inline Matrix3d diagonal(double x, double y, double z)
{
    return Vector3d(x, y, z).asDiagonal();
}

/// Pure shear in the xy plane.
inline Matrix3d shear(double tau)
{
    Matrix3d sigma = Matrix3d::Zero();
    sigma(0, 1) = sigma(1, 0) = tau;
    return sigma;
}

/// R σ Rᵀ, symmetric to the last bit.
inline Matrix3d turned(const Matrix3d& R, const Matrix3d& sigma)
{
    const Matrix3d result = R * sigma * R.transpose();
    return (result + result.transpose()) / 2;
}

inline Matrix3d deviator_of(const Matrix3d& A)
{
    return A - A.trace() / 3 * Matrix3d::Identity();
}

/// √(½ ((a - b)² + (b - c)² + (c - a)²) + 3 (xy² + yz² + zx²)), where a, b, c are on the diagonal.
inline double mises_of(const Matrix3d& A)
{
    const long double a = A(0, 0), b = A(1, 1), c = A(2, 2), xy = A(0, 1), yz = A(1, 2),
                      zx = A(2, 0);
    const long double differences = (a - b) * (a - b) + (b - c) * (b - c) + (c - a) * (c - a);
    return static_cast<double>(std::sqrt(differences / 2 + 3 * (xy * xy + yz * yz + zx * zx)));
}

/// A symmetric matrix with entries in [-1, 1).
inline Matrix3d random_symmetric(Random& random)
{
    Matrix3d A;
    A << random.vector(), random.vector(), random.vector();
    return (A + A.transpose()) / 2;
}

} // namespace rigor::testing
