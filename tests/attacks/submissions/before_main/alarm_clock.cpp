// SPDX-License-Identifier: MIT
// A constructor asks for a signal (SIGALRM) after one second.
// expect: 0 compile_error: before any function is called
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace {

[[gnu::constructor]] void set_alarm()
{
    alarm(1);
}

} // namespace

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
