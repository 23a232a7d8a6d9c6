// SPDX-License-Identifier: MIT
// Starts a process, by the instruction syscall itself.
// expect: 0 crashed: tried to start a thread or another process
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    long result = 0;
    asm volatile("syscall"
                 : "=a"(result)
                 : "a"(56L), "D"(17L), "S"(0L), "d"(0L)
                 : "rcx", "r11", "memory");
    return 0;
}

} // namespace rigor
