// SPDX-License-Identifier: MIT
// Returns from the handler of a crash to the instruction that crashed, for ever.
// expect: 0 timed_out
#include "formulas/pipeline.hpp"

#include <csignal>

namespace {

void again(int) {}

} // namespace

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    std::signal(SIGSEGV, again);
    struct sigaction action {};
    action.sa_handler = again;
    sigaction(SIGSEGV, &action, nullptr);
    *static_cast<volatile int*>(nullptr) = 1;
    return 0;
}

} // namespace rigor
