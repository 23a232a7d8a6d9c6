// SPDX-License-Identifier: MIT
// Data that has to be at a multiple of half a gigabyte.
// expect: 0 compile_error|passed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

alignas(1 << 28) char far_apart[2] = {1, 2};
asm(".section .far, \"aw\"; .p2align 29; .byte 1; .text");
