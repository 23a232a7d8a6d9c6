// SPDX-License-Identifier: MIT
// A right formula that leaves the x87 unit in single precision.
// expect: 1 passed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    const unsigned short control = 0x007f;
    asm volatile("fldcw %0" : : "m"(control));
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
