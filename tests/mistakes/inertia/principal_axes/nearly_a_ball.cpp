// SPDX-License-Identifier: MIT
// What is nearly a ball is taken for one, so small differences of its moments are lost.
#include "formulas/inertia.hpp"

#include <Eigen/Eigenvalues>

namespace rigor {

PrincipalAxes principal_axes(const Matrix3d& I)
{
    const double mean = I.trace() / 3;
    if ((I - mean * Matrix3d::Identity()).norm() < 1e-8 * I.norm())
        return {Matrix3d::Identity(), Vector3d::Constant(mean)};
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
    PrincipalAxes axes = {solver.eigenvectors(), solver.eigenvalues().cwiseMax(0.0)};
    if (axes.rotation.determinant() < 0) axes.rotation.col(0) *= -1;
    return axes;
}

} // namespace rigor
