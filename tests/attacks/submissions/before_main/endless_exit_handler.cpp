// SPDX-License-Identifier: MIT
// An exit handler never returns. It runs also when the build only tries whether the program starts.
// expect: 0 compile_error: does not return before any function is called
#include "formulas/pipeline.hpp"

#include <cstdlib>

namespace {

[[gnu::constructor]] void stay()
{
    std::atexit([] {
        for (volatile unsigned i = 0;; i = i + 1) {
        }
    });
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
