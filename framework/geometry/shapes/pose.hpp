// SPDX-License-Identifier: MIT
// Poses: position and rotation. Geometry computes rotations with Eigen. The code that moves bodies
// calls the functions of formulas/rotation.hpp instead, because students write these functions.
#pragma once

#include "formulas/types.hpp"
#include "geometry/shapes/shape.hpp"

namespace rigor {

/// A rotation and a translation, x = R p + X: p is in the local frame, x in the outer one.
struct Pose {
    Matrix3d R = Matrix3d::Identity();
    Vector3d X = Vector3d::Zero(); // [m]

    Vector3d operator*(const Vector3d& p) const { return R * p + X; }
    Pose operator*(const Pose& inner) const { return {R * inner.R, R * inner.X + X}; }
};

/// Rotation matrix of q / |q|. For the zero quaternion it is the identity.
Matrix3d rotation_matrix(const Quaternion& q);

/// Pose of a body.
Pose pose_of(const RigidState& state);

/// Unit quaternion of a matrix that is close to a rotation.
Quaternion quaternion_of(const Matrix3d& R);

/// Pose of a part in the frame in which its body has the pose `body`.
Pose part_pose(const Pose& body, const Part& part);

} // namespace rigor
