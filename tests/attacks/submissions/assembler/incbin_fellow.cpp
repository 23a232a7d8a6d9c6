// SPDX-License-Identifier: MIT
// Takes the object file of student/ into the program, whose build folder is near.
// expect: 0 compile_error
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

asm(".section .rodata; .incbin \"../../student/pipeline.o\"; .text");
