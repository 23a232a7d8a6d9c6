// SPDX-License-Identifier: MIT
// The order is reversed: R_x R_y R_z applies yaw first.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d euler_to_matrix(const Vector3d& angles)
{
    const Matrix3d R_x = Eigen::AngleAxisd(angles.x(), Vector3d::UnitX()).toRotationMatrix(),
                   R_y = Eigen::AngleAxisd(angles.y(), Vector3d::UnitY()).toRotationMatrix(),
                   R_z = Eigen::AngleAxisd(angles.z(), Vector3d::UnitZ()).toRotationMatrix();
    return R_x * R_y * R_z;
}

} // namespace rigor
