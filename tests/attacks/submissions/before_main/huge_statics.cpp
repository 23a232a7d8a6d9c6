// SPDX-License-Identifier: MIT
// Global data that no limit on memory has room for.
// expect: 0 compile_error: cannot be linked
#include "formulas/pipeline.hpp"

namespace {

volatile char much[3ul << 30];

} // namespace

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    much[mass > 0 ? 1 : 2] = 1;
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
