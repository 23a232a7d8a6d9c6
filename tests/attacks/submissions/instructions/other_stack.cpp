// SPDX-License-Identifier: MIT
// Computes on a stack of its own, and comes back.
// expect: 1 passed|crashed
#include "formulas/pipeline.hpp"

#include <ucontext.h>

namespace rigor {

ucontext_t caller, computing;
alignas(16) char stack[65536];
double energy = 0;

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    energy = 0.5 * mass * velocity.squaredNorm() +
             0.5 * angular_velocity.dot(inertia * angular_velocity);
    getcontext(&computing);
    computing.uc_stack.ss_sp = stack;
    computing.uc_stack.ss_size = sizeof stack;
    computing.uc_link = &caller;
    makecontext(
        &computing, [] { energy += 0; }, 0);
    swapcontext(&caller, &computing);
    return energy;
}

} // namespace rigor
