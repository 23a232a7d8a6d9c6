// SPDX-License-Identifier: MIT
// Is wrong within a microsecond of the first call of its process, and right later.
// expect: 0 failed
#include "formulas/pipeline.hpp"

#include <ctime>

namespace {

timespec first = {};

} // namespace

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    timespec now = {};
    clock_gettime(CLOCK_MONOTONIC, &now);
    if (first.tv_sec == 0) first = now;
    if (now.tv_sec == first.tv_sec && now.tv_nsec - first.tv_nsec < 1000) return 0;
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
