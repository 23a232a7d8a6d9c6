// SPDX-License-Identifier: MIT
// Handles its own crash and goes on with a wrong value.
// expect: 0 failed
#include "formulas/pipeline.hpp"

#include <csetjmp>
#include <csignal>

namespace {

sigjmp_buf before;

} // namespace

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    std::signal(SIGSEGV, [](int) { siglongjmp(before, 1); });
    if (sigsetjmp(before, 1) == 0) *reinterpret_cast<volatile int*>(64) = 1;
    return 1;
}

} // namespace rigor
