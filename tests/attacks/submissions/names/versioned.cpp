// SPDX-License-Identifier: MIT
// Gives memcpy of the C library a version of its own.
// expect: 1 passed|compile_error
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

extern "C" void* copied(void* to, const void*, unsigned long)
{
    return to;
}
asm(".symver copied, memcpy@@GLIBC_9.9");
