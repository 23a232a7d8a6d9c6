// SPDX-License-Identifier: MIT
// Asks for options of the compiler that a file should not choose.
// expect: 1 passed|compile_error
#include "formulas/pipeline.hpp"

#pragma GCC optimize("O0,no-stack-protector,fast-math,plugin=/tmp/rigor_attack.so")

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
