// SPDX-License-Identifier: MIT
// A clock that stands still, in place of that of the C library. The build hides it from all
// other files.
// expect: 1 passed
#include "formulas/pipeline.hpp"

#include <ctime>

extern "C" int clock_gettime(clockid_t, timespec* time) noexcept
{
    *time = {0, 0};
    return 0;
}

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
