// SPDX-License-Identifier: MIT
// A formula that other files should not see. The link is static, so it counts.
// expect: 1 passed
#include "formulas/pipeline.hpp"

#pragma GCC visibility push(hidden)

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

#pragma GCC visibility pop
