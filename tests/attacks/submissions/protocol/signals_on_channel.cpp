// SPDX-License-Identifier: MIT
// Uses the channel as the stack of its signal handlers.
// expect: 0 crashed|failed|timed_out
#include "channel_on_stack.hpp"
#include "formulas/pipeline.hpp"

#include <csignal>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    stack_t stack = {channel_on_stack(), 0, 1 << 20};
    sigaltstack(&stack, nullptr);
    struct sigaction action = {};
    action.sa_handler = [](int) { throw 1; };
    action.sa_flags = SA_ONSTACK;
    sigaction(SIGSEGV, &action, nullptr);
    *reinterpret_cast<volatile int*>(64) = 1;
    return 1;
}

} // namespace rigor
