// SPDX-License-Identifier: MIT
// Computes once, and gives this answer to every later question.
// expect: 0 failed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    static const double once = 0.5 * mass * velocity.squaredNorm() +
                               0.5 * angular_velocity.dot(inertia * angular_velocity);
    return once;
}

} // namespace rigor
