// SPDX-License-Identifier: MIT
// Principal stresses instead of norms, Voigt's 6×6 stiffness, and the radial return.
// The return scales the deviator to the yield surface; the difference becomes plastic strain.
#include "formulas/plasticity.hpp"

#include <cmath>
#include <limits>

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    // the diagonal is ⅓ (2 σ_xx - σ_yy - σ_zz), and so on
    Matrix3d s = stress;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        s(i, i) = ((stress(i, i) - stress(j, j)) + (stress(i, i) - stress(k, k))) / 3;
    }
    return s;
}

double von_mises_principal(double stress1, double stress2, double stress3)
{
    return std::hypot(stress1 - stress2, stress2 - stress3, stress3 - stress1) * std::sqrt(0.5);
}

double von_mises_frobenius(const Matrix3d& stress)
{
    // ‖σ‖² = Tr(σ σ) for symmetric σ
    const double square = 3 * (stress * stress).trace() - std::pow(stress.trace(), 2);
    return square > 0 ? std::sqrt(square / 2) : 0;
}

double von_mises(const Matrix3d& stress)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(stress, Eigen::EigenvaluesOnly);
    const Vector3d sigma = solver.eigenvalues();
    return von_mises_principal(sigma[2], sigma[0], sigma[1]);
}

Matrix3d isotropic_stress(const Matrix3d& strain, double lame_lambda, double shear_modulus)
{
    // (σ_xx, σ_yy, σ_zz, σ_yz, σ_zx, σ_xy) = C (ε_xx, ε_yy, ε_zz, 2 ε_yz, 2 ε_zx, 2 ε_xy)
    Matrix6d C = Matrix6d::Zero();
    C.topLeftCorner<3, 3>().setConstant(lame_lambda);
    C.diagonal() += shear_modulus * (Eigen::Matrix<double, 6, 1>() << 2, 2, 2, 1, 1, 1).finished();
    Eigen::Matrix<double, 6, 1> e;
    e << strain.diagonal(), 2 * strain(1, 2), 2 * strain(2, 0), 2 * strain(0, 1);
    const Eigen::Matrix<double, 6, 1> s = C * e;
    Matrix3d stress;
    stress << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
    return stress;
}

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    // the von Mises stress of 2 G ε, which differs from the true stress only in its pressure
    return von_mises(2 * shear_modulus * strain);
}

double yield_strain(double yield_stress, double shear_modulus)
{
    return shear_modulus > 0 ? 0.5 * yield_stress / shear_modulus
                             : std::numeric_limits<double>::infinity();
}

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    const Matrix3d s = deviator(stress);
    const double q = std::sqrt(1.5) * s.norm();
    if (q <= yield_stress || shear_modulus == 0) return plastic_strain;

    // dev σ shrinks to σ_Y/q of its size, and the difference becomes plastic strain
    const Matrix3d s_new = yield_stress / q * s;
    return plastic_strain + (s - s_new) / (2 * shear_modulus);
}

} // namespace rigor
