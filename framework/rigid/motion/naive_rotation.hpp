// SPDX-License-Identifier: MIT
// Two ways of the lecture to advance an orientation that lead nowhere: a matrix that Gram–Schmidt
// repairs, and Euler angles. They are here to be watched.
#pragma once

#include "rigid/bodies/body.hpp"

namespace rigor {

/// The orientation after a step under a constant angular velocity in world space:
/// `advance_matrix` turns the matrix, and `gram_schmidt` makes it a rotation again.
Quaternion turned_by_gram_schmidt(const Quaternion& q, const Vector3d& omega, double time_step);

/// The same by one Euler step of the angles (`euler_rates`, `euler_to_matrix`). At gimbal lock
/// there are no rates, and the orientation stays as it is.
Quaternion turned_by_euler_angles(const Quaternion& q, const Vector3d& omega, double time_step);

} // namespace rigor
