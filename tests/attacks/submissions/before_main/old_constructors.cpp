// SPDX-License-Identifier: MIT
// A table of constructors of the old kind, which nothing reads.
// expect: 1 passed|compile_error
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

asm(R"(
    .section .ctors, "aw"
    .quad leave
    .text
leave:
    hlt
)");
