// SPDX-License-Identifier: MIT
// Says that the disk is full, which would be a fault of the grader and not of the submission.
// expect: 0 compile_error
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

#error No space left on device
