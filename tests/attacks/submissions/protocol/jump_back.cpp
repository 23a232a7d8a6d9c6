// SPDX-License-Identifier: MIT
// Jumps back (longjmp) into the call before, whose stack frame is gone.
// expect: 0 crashed|failed|timed_out
#include "formulas/pipeline.hpp"

#include <csetjmp>

namespace {

std::jmp_buf before;
int calls = 0;

} // namespace

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    if (++calls > 1) std::longjmp(before, 1);
    if (setjmp(before) > 1) return 2;
    return 1;
}

} // namespace rigor
