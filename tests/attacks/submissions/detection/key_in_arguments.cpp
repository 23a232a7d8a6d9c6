// SPDX-License-Identifier: MIT
// Is right if the program was started with arguments, among which the key of the random cases could
// be.
// expect: 0 failed
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace {

int number_of_arguments = 0;

[[gnu::constructor]] void count(int arguments)
{
    number_of_arguments = arguments;
}

} // namespace

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    if (number_of_arguments < 2) return 0;
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
