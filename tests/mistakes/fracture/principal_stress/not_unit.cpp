// SPDX-License-Identifier: MIT
// The direction has the length of the eigenvalue; it must be a unit vector.
#include "formulas/fracture.hpp"

namespace rigor {

PrincipalStress principal_stress(const Matrix3d& stress)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(stress);
    return {eigen.eigenvalues()[2], eigen.eigenvalues()[2] * eigen.eigenvectors().col(2)};
}

} // namespace rigor
