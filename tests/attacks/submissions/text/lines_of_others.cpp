// SPDX-License-Identifier: MIT
// Gives its lines to a file whose name clears the screen and runs backwards.
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

#line 7 "\033[2J\xE2\x80\xAEreference/pipeline.cpp"
#error "\u202E\u2066 not mine"
int x = ;
