// SPDX-License-Identifier: MIT
// A constant that takes for ever to compute.
// expect: 0 compile_error: constexpr
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

constexpr int count()
{
    int n = 0;
    for (unsigned long i = 0; i < 1ul << 62; ++i)
        n ^= 1;
    return n;
}
static_assert(count() == 0);
