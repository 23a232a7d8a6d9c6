// SPDX-License-Identifier: MIT
// Sums over components in long double, the rotation first.
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    long double twice = 0;
    for (int j = 2; j >= 0; --j)
        for (int i = 2; i >= 0; --i)
            twice +=
                static_cast<long double>(inertia(i, j)) * angular_velocity[i] * angular_velocity[j];
    for (int i = 0; i < 3; ++i)
        twice += static_cast<long double>(mass) * velocity[i] * velocity[i];
    return static_cast<double>(twice / 2);
}

} // namespace rigor
