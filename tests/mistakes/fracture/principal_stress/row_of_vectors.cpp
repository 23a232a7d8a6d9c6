// SPDX-License-Identifier: MIT
// A row of the matrix whose columns are the eigenvectors.
#include "formulas/fracture.hpp"

namespace rigor {

PrincipalStress principal_stress(const Matrix3d& stress)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(stress);
    return {eigen.eigenvalues()[2], eigen.eigenvectors().row(2).transpose()};
}

} // namespace rigor
