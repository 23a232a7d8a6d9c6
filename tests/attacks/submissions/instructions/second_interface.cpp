// SPDX-License-Identifier: MIT
// Makes a system call by the numbers of x32, the second interface of 64 bits.
// expect: 0 crashed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    long result = 0;
    asm volatile("syscall"
                 : "=a"(result)
                 : "a"(0x40000000L + 60), "D"(0L)
                 : "rcx", "r11", "memory");
    return 0;
}

} // namespace rigor
