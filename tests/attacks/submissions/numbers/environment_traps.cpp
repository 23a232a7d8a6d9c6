// SPDX-License-Identifier: MIT
// Switches on the traps for all exceptions but inexact results, and divides by zero.
// expect: 0 crashed|failed
#include "formulas/pipeline.hpp"

#include <cfenv>

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    feenableexcept(FE_ALL_EXCEPT & ~FE_INEXACT);
    volatile double none = 0;
    none = 1 / none;
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
