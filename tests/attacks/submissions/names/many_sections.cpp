// SPDX-License-Identifier: MIT
// Twenty thousand sections.
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

asm(R"(
    .altmacro
    .macro one n
    .section .many.\n, "a"
    .byte 1
    .endm
    .set i, 0
    .rept 20000
    one %i
    .set i, i + 1
    .endr
    .text
)");
