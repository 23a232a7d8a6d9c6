// SPDX-License-Identifier: MIT
// Exchanges keywords by macros.
// expect: 0 crashed|compile_error
#include "formulas/pipeline.hpp"

#define return throw

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
