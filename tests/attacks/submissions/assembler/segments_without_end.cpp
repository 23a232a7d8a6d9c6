// SPDX-License-Identifier: MIT
// Makes more segments than the system loads, by sections that take turns in what they allow. The
// program is linked, but cannot be run.
// expect: 0 compile_error: makes a program that the system cannot run
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
.macro both k
.pushsection .note.z\k\()a, "a", @note
.long 0
.popsection
.pushsection .note.z\k\()b, "aw", @note
.long 0
.popsection
.endm
.set i, 1000
.rept 900
both %i
.set i, i + 1
.endr
)");
