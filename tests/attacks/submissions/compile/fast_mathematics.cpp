// SPDX-License-Identifier: MIT
// Asks for fast mathematics. The result is close enough.
// expect: 1 passed
#pragma GCC optimize("Ofast")
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
