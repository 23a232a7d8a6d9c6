// SPDX-License-Identifier: MIT
// Takes a tensor with an ascending diagonal for diagonal if its products of inertia are below a
// trillionth of it.
#include "formulas/inertia.hpp"

namespace rigor {

PrincipalAxes principal_axes(const Matrix3d& I)
{
    PrincipalAxes result;
    if (I.isDiagonal() && I(0, 0) <= I(1, 1) && I(1, 1) <= I(2, 2)) {
        result.moments = I.diagonal().cwiseMax(0.0);
        return result;
    }
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
    result.rotation = solver.eigenvectors();
    if (result.rotation.determinant() < 0) result.rotation.col(0) *= -1;
    result.moments = solver.eigenvalues().cwiseMax(0.0);
    return result;
}

} // namespace rigor
