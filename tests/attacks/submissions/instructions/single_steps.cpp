// SPDX-License-Identifier: MIT
// Sets the flag with which the processor stops after each instruction, and returns.
// expect: 0 crashed|passed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    asm volatile("pushfq; orq $0x100, (%%rsp); popfq" ::: "memory", "cc");
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
