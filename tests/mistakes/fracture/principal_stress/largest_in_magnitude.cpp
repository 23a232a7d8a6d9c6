// SPDX-License-Identifier: MIT
// The largest absolute value is chosen, which can be a compression, not the largest eigenvalue.
#include "formulas/fracture.hpp"

namespace rigor {

PrincipalStress principal_stress(const Matrix3d& stress)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(stress);
    Eigen::Index i = 0;
    eigen.eigenvalues().cwiseAbs().maxCoeff(&i);
    return {eigen.eigenvalues()[i], eigen.eigenvectors().col(i)};
}

} // namespace rigor
