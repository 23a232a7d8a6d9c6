// SPDX-License-Identifier: MIT
// Forbids itself the instruction cpuid, which says which processor this is.
// expect: 0 crashed|passed
#include "formulas/pipeline.hpp"

#include <sys/syscall.h>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    syscall(SYS_arch_prctl, 0x1012, 0);
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
