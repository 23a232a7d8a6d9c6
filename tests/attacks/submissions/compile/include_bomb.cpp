// SPDX-License-Identifier: MIT
// Includes itself twice, and each copy does so again.
// expect: 0 compile_error
#include "formulas/pipeline.hpp"
#include __FILE__
#include __FILE__

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
