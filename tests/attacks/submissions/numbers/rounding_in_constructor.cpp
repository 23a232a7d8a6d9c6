// SPDX-License-Identifier: MIT
// A constructor that lets the processor round upward for all that follows.
// expect: 1 passed
#include "formulas/pipeline.hpp"

#include <cfenv>

namespace {

[[gnu::constructor]] void round_upward()
{
    std::fesetround(FE_UPWARD);
}

} // namespace

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
