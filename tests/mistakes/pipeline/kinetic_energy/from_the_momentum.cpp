// SPDX-License-Identifier: MIT
// The square of the momentum may be too large or too small for a double where the energy is not.
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    const Vector3d P = mass * velocity;
    const double move = mass == 0 ? 0.0 : P.squaredNorm() / (2 * mass);
    return move + 0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
