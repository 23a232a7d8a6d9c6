// SPDX-License-Identifier: MIT
// The ½ of the rotational energy ½ ω·I ω is missing.
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.dot(velocity) + angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
