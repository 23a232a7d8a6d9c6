// SPDX-License-Identifier: MIT
// Where something is: the framework's own rotation arithmetic, by Eigen, for its geometry. The
// motion of bodies goes through the formulas instead.
#pragma once

#include "formulas/types.hpp"
#include "geometry/shapes/shape.hpp"

namespace rigor {

/// A rotation and a translation, x = R p + X.
struct Pose {
    Matrix3d R = Matrix3d::Identity();
    Vector3d X = Vector3d::Zero(); // [m]

    Vector3d operator*(const Vector3d& p) const { return R * p + X; }
    Pose operator*(const Pose& inner) const { return {R * inner.R, R * inner.X + X}; }
};

/// Rotation matrix of q / |q|; of the zero quaternion, the identity.
Matrix3d rotation_matrix(const Quaternion& q);

/// Pose of a body.
Pose pose_of(const RigidState& state);

/// Unit quaternion of a matrix that is close to a rotation.
Quaternion quaternion_of(const Matrix3d& R);

/// Pose of a part whose body is at `body`.
Pose part_pose(const Pose& body, const Part& part);

} // namespace rigor
