// SPDX-License-Identifier: MIT
// isZero() has an absolute precision of 1e-12, so a slow turn counts as none.
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    const double translation = 0.5 * mass * velocity.squaredNorm();
    if (angular_velocity.isZero()) return translation;
    return translation + 0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
