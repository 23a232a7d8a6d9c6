// SPDX-License-Identifier: MIT
// Moves the thread-local variables to address zero.
// expect: 0 crashed
#include "formulas/pipeline.hpp"

#include <sys/syscall.h>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    syscall(SYS_arch_prctl, 0x1002, 0);
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
