// SPDX-License-Identifier: MIT
// Lets the compiler speak: notes, warnings and a failed assertion with control characters.
// expect: 0 compile_error
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

#pragma message "\033]0;title\007"
[[deprecated("\033[31m 1/1 passed \u2028")]] int old();
int again = old();
static_assert(again == 0, "\u202E\u0085\033[2J A0.1   kinetic_energy   1/1   passed");
