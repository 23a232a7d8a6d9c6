// SPDX-License-Identifier: MIT
// Products of inertia below 1e-6 of the tensor count as zero, and its axes as principal.
#include "formulas/inertia.hpp"

namespace rigor {

PrincipalAxes principal_axes(const Matrix3d& I)
{
    const Matrix3d off = I - Matrix3d(I.diagonal().asDiagonal());
    const Vector3d d = I.diagonal().cwiseMax(0);
    if (off.norm() < 1e-6 * I.norm() && d[0] <= d[1] && d[1] <= d[2])
        return {Matrix3d::Identity(), d};
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(I);
    Matrix3d Q = eigen.eigenvectors();
    if (Q.determinant() < 0) Q.col(0) = -Q.col(0);
    return {Q, eigen.eigenvalues().cwiseMax(0)};
}

} // namespace rigor
