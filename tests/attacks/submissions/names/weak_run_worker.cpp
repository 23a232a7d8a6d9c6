// SPDX-License-Identifier: MIT
// Functions of the worker with a weak definition.
// expect: 1 passed
#include "formulas/pipeline.hpp"

asm(R"(
    .weak _ZN5rigor10run_workerEb
    .weak _ZN5rigor6Server10serve_nextEv
    .weak rigor_run_scenes
_ZN5rigor10run_workerEb:
_ZN5rigor6Server10serve_nextEv:
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
