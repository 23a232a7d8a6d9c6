// SPDX-License-Identifier: MIT
// A rotation with less than a millionth of the energy of the translation is ignored.
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    const double translation = 0.5 * mass * velocity.squaredNorm();
    const double rotation = 0.5 * angular_velocity.dot(inertia * angular_velocity);
    return rotation < 1e-6 * translation ? translation : translation + rotation;
}

} // namespace rigor
