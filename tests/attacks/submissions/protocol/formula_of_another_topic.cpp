// SPDX-License-Identifier: MIT
// Formulas of another topic, which this file is not asked for.
// expect: 1 passed
#include "formulas/kinematics.hpp"
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    return Matrix3d::Zero();
}

} // namespace rigor
