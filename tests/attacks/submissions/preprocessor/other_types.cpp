// SPDX-License-Identifier: MIT
// Gives the types of the contract other meanings. The formula has another signature then.
// expect: 0 compile_error: kinetic_energy
#include "formulas/pipeline.hpp"

#define double float

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
