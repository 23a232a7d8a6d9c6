// SPDX-License-Identifier: MIT
// Converts quaternions and rotation matrices into each other, and combines the poses of a body and
// its parts. Quaternions are scaled to unit length.
#include "geometry/shapes/pose.hpp"

namespace rigor {

Matrix3d rotation_matrix(const Quaternion& q)
{
    Eigen::Quaterniond unit(q.s, q.v.x(), q.v.y(), q.v.z());
    const double length = unit.norm();
    if (!(length > 0)) return Matrix3d::Identity();
    unit.coeffs() /= length;
    return unit.toRotationMatrix();
}

Quaternion quaternion_of(const Matrix3d& R)
{
    const Eigen::Quaterniond q = Eigen::Quaterniond(R).normalized();
    return {q.w(), q.vec()};
}

Pose pose_of(const RigidState& state)
{
    return {rotation_matrix(state.orientation), state.position};
}

Pose part_pose(const Pose& body, const Part& part)
{
    if (part.orientation.v.isZero(0))
        return part.position.isZero(0) ? body : Pose{body.R, body * part.position};
    return body * Pose{rotation_matrix(part.orientation), part.position};
}

} // namespace rigor
