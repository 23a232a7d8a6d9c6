// SPDX-License-Identifier: MIT
// Makes a system call by the interface of 32 bits (int 0x80), where the numbers mean other calls.
// expect: 0 crashed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    long result = 0;
    asm volatile("int $0x80" : "=a"(result) : "a"(1L), "b"(0L) : "memory");
    return 0;
}

} // namespace rigor
