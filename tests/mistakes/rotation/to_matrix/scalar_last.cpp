// SPDX-License-Identifier: MIT
// The quaternion is read as (x, y, z, s); the scalar part comes first.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d to_matrix(const Quaternion& q)
{
    return Eigen::Quaterniond(q.v.z(), q.s, q.v.x(), q.v.y()).toRotationMatrix();
}

} // namespace rigor
