// SPDX-License-Identifier: MIT
// The angles are negated, so that each rotation goes the wrong way.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d euler_to_matrix(const Vector3d& angles)
{
    const Matrix3d R_x = Eigen::AngleAxisd(angles.x(), Vector3d::UnitX()).toRotationMatrix(),
                   R_y = Eigen::AngleAxisd(angles.y(), Vector3d::UnitY()).toRotationMatrix(),
                   R_z = Eigen::AngleAxisd(angles.z(), Vector3d::UnitZ()).toRotationMatrix();
    return R_z.transpose() * R_y.transpose() * R_x.transpose();
}

} // namespace rigor
