// SPDX-License-Identifier: MIT
// Two simple ways from the lecture to advance an orientation, each with a fault that students can
// watch: a matrix that Gram–Schmidt repairs is biased, and Euler angles fail at gimbal lock.
#pragma once

#include "rigid/bodies/body.hpp"

namespace rigor {

/// The orientation after a step under a constant angular velocity in world space:
/// `advance_matrix` turns the matrix, and `gram_schmidt` makes it a rotation again.
Quaternion turned_by_gram_schmidt(const Quaternion& q, const Vector3d& omega, double time_step);

/// The orientation after a step under a constant angular velocity in world space, by one Euler
/// step of the Euler angles (`euler_rates`, `euler_to_matrix`). At gimbal lock the rates of the
/// angles do not exist, and the orientation stays as it is.
Quaternion turned_by_euler_angles(const Quaternion& q, const Vector3d& omega, double time_step);

} // namespace rigor
