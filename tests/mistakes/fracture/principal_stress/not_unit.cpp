// SPDX-License-Identifier: MIT
// The eigenvector as long as the eigenvalue.
#include "formulas/fracture.hpp"

namespace rigor {

PrincipalStress principal_stress(const Matrix3d& stress)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(stress);
    return {eigen.eigenvalues()[2], eigen.eigenvalues()[2] * eigen.eigenvectors().col(2)};
}

} // namespace rigor
