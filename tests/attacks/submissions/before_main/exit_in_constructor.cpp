// SPDX-License-Identifier: MIT
// A constructor ends the program with success.
// expect: 0 compile_error: ends the program before any function is called
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace {

[[gnu::constructor]] void leave()
{
    _exit(0);
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
