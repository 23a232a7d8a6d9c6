// SPDX-License-Identifier: MIT
// Asks to be traced, by the instruction syscall itself.
// expect: 0 crashed: tried to look into another process
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    long result = 0;
    asm volatile("syscall" : "=a"(result) : "a"(101L), "D"(0L) : "rcx", "r11", "memory");
    return 0;
}

} // namespace rigor
