// SPDX-License-Identifier: MIT
// Takes from itself all rights to its memory, by the register of protection keys.
// expect: 0 crashed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    asm volatile("xorl %%ecx, %%ecx; xorl %%edx, %%edx; movl $-1, %%eax; wrpkru" ::
                     : "eax", "ecx", "edx", "memory");
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
