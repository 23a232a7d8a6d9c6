// SPDX-License-Identifier: MIT
// Takes a second in each call, which is less than the limit of a call.
// expect: 0 timed_out
#include "formulas/pipeline.hpp"

#include <ctime>

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    const timespec second = {1, 0};
    nanosleep(&second, nullptr);
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
