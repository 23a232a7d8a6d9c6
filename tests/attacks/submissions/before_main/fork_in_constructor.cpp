// SPDX-License-Identifier: MIT
// A constructor starts another process.
// expect: 0 compile_error: tries to start a thread or another process before any function
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace {

[[gnu::constructor]] void multiply()
{
    if (fork() == 0) pause();
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
