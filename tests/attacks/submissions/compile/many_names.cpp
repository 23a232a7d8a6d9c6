// SPDX-License-Identifier: MIT
// Defines a hundred thousand names.
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

asm(R"(
    .macro name
    .globl many\@
many\@:
    .endm
    .rept 100000
    name
    .endr
)");
