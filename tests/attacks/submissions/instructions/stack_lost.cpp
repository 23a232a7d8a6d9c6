// SPDX-License-Identifier: MIT
// Returns with the stack pointer in an array of zeros, so to address 0.
// expect: 0 crashed
#include "formulas/pipeline.hpp"

namespace rigor {

alignas(16) char zeros[65536];

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    asm volatile("movq %0, %%rsp; ret" ::"r"(zeros + 32768));
    return 1;
}

} // namespace rigor
