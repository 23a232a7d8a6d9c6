// SPDX-License-Identifier: MIT
// A main function with the binding that exists once in a program. The build makes it local to this
// file.
// expect: 1 passed
#include "formulas/pipeline.hpp"

asm(R"(
    .globl main
    .type main, @gnu_unique_object
main:
    ret
)");

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
