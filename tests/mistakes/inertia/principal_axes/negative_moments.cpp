// SPDX-License-Identifier: MIT
// A moment that is negative because of rounding must be set to 0; no body has a negative one.
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
