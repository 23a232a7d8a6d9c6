// SPDX-License-Identifier: MIT
// The largest absolute value decides, so that strong compression opens a crack.
#include "formulas/fracture.hpp"

namespace rigor {

std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(stress);
    Eigen::Index i = 0;
    if (eigen.eigenvalues().cwiseAbs().maxCoeff(&i) <= threshold) return {};
    return eigen.eigenvectors().col(i);
}

} // namespace rigor
