// SPDX-License-Identifier: MIT
// Defines a symbol with a newline in its name, which looks like several symbols in a list.
// expect: 0 compile_error: invalid character in a name
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

asm(".globl \"a\\nmain T 0 0\\nb\"; \"a\\nmain T 0 0\\nb\": ret");
