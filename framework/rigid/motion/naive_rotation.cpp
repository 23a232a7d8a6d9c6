// SPDX-License-Identifier: MIT
// Two simple ways to advance an orientation (lecture "Inertia, rotation, impulses"). The quaternion
// is converted to a matrix or to Euler angles. These are advanced by the step and converted
// back. Of the two quaternions of a rotation, the result is the one nearer to the quaternion before
// the step.
#include "rigid/motion/naive_rotation.hpp"

#include "formulas/rotation.hpp"
#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/orientation.hpp"

#include <cmath>

namespace rigor {

namespace {

// Roll, pitch and yaw of R = R_z(ψ) R_y(θ) R_x(φ), with the pitch from -π/2 to π/2.
Vector3d angles_of(const Matrix3d& R)
{
    const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
    return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

} // namespace

Quaternion turned_by_gram_schmidt(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const Matrix3d R = gram_schmidt(advance_matrix(rotation_matrix(q), omega, time_step));
    return nearer_quaternion_of(R, q);
}

Quaternion turned_by_euler_angles(const Quaternion& q, const Vector3d& omega, double time_step)
{
    const Vector3d angles = angles_of(rotation_matrix(q));
    const std::optional<Vector3d> rates = euler_rates(angles, omega);
    if (!rates) return q; // gimbal lock
    return nearer_quaternion_of(euler_to_matrix(angles + time_step * *rates), q);
}

} // namespace rigor
