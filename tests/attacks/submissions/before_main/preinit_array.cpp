// SPDX-License-Identifier: MIT
// An entry of the table that runs before all constructors, written by the assembler.
// expect: 0 compile_error: ends the program before any function
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

asm(R"(
    .section .preinit_array, "aw"
    .quad leave_first
    .text
leave_first:
    mov $231, %eax
    xor %edi, %edi
    syscall
)");
