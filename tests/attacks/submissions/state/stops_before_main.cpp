// SPDX-License-Identifier: MIT
// Stops its process before the main function. The grader does not wait for it.
// expect: 0 compile_error: stops itself
#include "formulas/pipeline.hpp"

#include <csignal>

namespace {

[[gnu::constructor]] void stop()
{
    raise(SIGSTOP);
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
