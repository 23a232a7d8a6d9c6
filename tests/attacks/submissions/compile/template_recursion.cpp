// SPDX-License-Identifier: MIT
// A template without end.
// expect: 0 compile_error: template instantiation
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

template <int n> struct Deep : Deep<n + 1> {
};
Deep<0> deep;
