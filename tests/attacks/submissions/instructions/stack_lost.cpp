// SPDX-License-Identifier: MIT
// Returns on a stack of zeros.
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
