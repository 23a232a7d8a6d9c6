// SPDX-License-Identifier: MIT
// The matrix of a half turn is 2 v vᵀ - δ; without the δ it is no rotation.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d to_matrix(const Quaternion& q)
{
    if (q.s == 0) return 2 * q.v * q.v.transpose();
    return Eigen::Quaterniond(q.s, q.v.x(), q.v.y(), q.v.z()).toRotationMatrix();
}

} // namespace rigor
