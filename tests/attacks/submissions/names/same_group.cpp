// SPDX-License-Identifier: MIT
// A group of sections with the name of a function of the worker. The linker keeps only one copy of
// such a group.
// expect: 1 passed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

asm(R"(
    .section .text._ZN5rigor10run_workerEb, "axG", @progbits, _ZN5rigor10run_workerEb, comdat
    .weak _ZN5rigor10run_workerEb
_ZN5rigor10run_workerEb:
    hlt
    .text
)");
