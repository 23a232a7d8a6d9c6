// SPDX-License-Identifier: MIT
// A constructor closes the channel before the worker can take it.
// expect: 0 crashed: the start of the program ended the program
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace {

[[gnu::constructor]] void hang_up()
{
    close(3);
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
