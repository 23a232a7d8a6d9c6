// SPDX-License-Identifier: MIT
// The products of inertia are left out if their sum is exactly 0, as if each of them were 0.
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    const double products = inertia(0, 1) + inertia(0, 2) + inertia(1, 2);
    const Vector3d L = products == 0 ? Vector3d(inertia.diagonal().cwiseProduct(angular_velocity))
                                     : Vector3d(inertia * angular_velocity);
    return 0.5 * mass * velocity.dot(velocity) + 0.5 * angular_velocity.dot(L);
}

} // namespace rigor
