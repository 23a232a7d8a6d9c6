// SPDX-License-Identifier: MIT
// A global variable whose value takes seconds, at each start of the program. A0 has one task, and
// so few starts that their time may be enough.
// expect: 0 timed_out|passed
#include "formulas/pipeline.hpp"

#include <ctime>

namespace {

int sleep_for_seconds()
{
    const timespec time = {4, 0};
    nanosleep(&time, nullptr);
    return 0;
}

[[maybe_unused]] const int slept = sleep_for_seconds();

} // namespace

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
