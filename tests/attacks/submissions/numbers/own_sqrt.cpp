// SPDX-License-Identifier: MIT
// A square root in place of that of the C library. The build makes it local to this file.
// expect: 1 passed
#include "formulas/pipeline.hpp"

extern "C" double sqrt(double)
{
    return -1;
}

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
