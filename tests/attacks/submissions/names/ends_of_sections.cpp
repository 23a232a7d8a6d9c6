// SPDX-License-Identifier: MIT
// Defines the names by which the start of a program finds its constructors.
// expect: 0 crashed|compile_error|passed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

asm(".globl __init_array_start, __init_array_end, _end, __bss_start, __ehdr_start\n"
    "__init_array_start = 8\n__init_array_end = 4096\n_end = 1\n__bss_start = 0\n"
    "__ehdr_start = 1");
