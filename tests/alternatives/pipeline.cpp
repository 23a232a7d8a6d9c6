// SPDX-License-Identifier: MIT
// Adds the products of components one by one, in another order.
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    double twice = 0;
    for (int i = 2; i >= 0; --i)
        for (int j = 0; j < 3; ++j)
            twice += angular_velocity[i] * inertia(i, j) * angular_velocity[j];
    for (int i = 0; i < 3; ++i)
        twice += velocity[i] * velocity[i] * mass;
    return twice / 2;
}

} // namespace rigor
