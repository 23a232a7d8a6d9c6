// SPDX-License-Identifier: MIT
// Changes registers that a function must keep.
// expect: 0 crashed|timed_out|failed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    asm volatile("xor %%ebx, %%ebx; xor %%r12d, %%r12d; xor %%r13d, %%r13d; xor %%r14d, %%r14d"
                 :
                 :
                 : "memory");
    return 0;
}

} // namespace rigor
