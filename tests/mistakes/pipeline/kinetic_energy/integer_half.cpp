// SPDX-License-Identifier: MIT
// `1 / 2` is an integer division and gives 0, so the energy is zero.
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 1 / 2 * mass * velocity.dot(velocity) +
           1 / 2 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
