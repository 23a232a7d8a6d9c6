// SPDX-License-Identifier: MIT
// Asks a linker for a library by a section that some linkers read.
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

asm(".section .deplibs, \"MS\", @llvm_dependent_libraries, 1; .asciz \"/tmp/rigor_attack.a\"; "
    ".text");
