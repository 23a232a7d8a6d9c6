// SPDX-License-Identifier: MIT
// A second function like main, with default visibility and an alias.
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

extern "C" [[gnu::visibility("default")]] int another_main()
{
    return 0;
}

extern "C" [[gnu::alias("another_main")]] int _start_worker();
