// SPDX-License-Identifier: MIT
// A scalar part that is nearly 1 is taken for a turn by 0.
#include "formulas/rotation.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace rigor {

Matrix3d to_matrix(const Quaternion& q)
{
    if (std::abs(q.s) > 1 - 1e-12) return Matrix3d::Identity();
    return Eigen::Quaterniond(q.s, q.v.x(), q.v.y(), q.v.z()).toRotationMatrix();
}

} // namespace rigor
