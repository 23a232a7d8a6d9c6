// SPDX-License-Identifier: MIT
// A function that a label gives the linker name of the worker's loop.
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

int serve(bool) asm("_ZN5rigor10run_workerEb");

int serve(bool)
{
    return 0;
}
