// SPDX-License-Identifier: MIT
// Returns the last answer again if the mass is nearly that of the call before.
// expect: 0 failed
#include "formulas/pipeline.hpp"

#include <cmath>

namespace {

double last_mass = -1, last = 0;

} // namespace

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    if (std::abs(mass - last_mass) < 1) return last;
    last_mass = mass;
    last = 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
