// SPDX-License-Identifier: MIT
// The first eigenvalue is returned; they are sorted in ascending order, so the largest is the last.
#include "formulas/fracture.hpp"

namespace rigor {

PrincipalStress principal_stress(const Matrix3d& stress)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(stress);
    return {eigen.eigenvalues()[0], eigen.eigenvectors().col(0)};
}

} // namespace rigor
