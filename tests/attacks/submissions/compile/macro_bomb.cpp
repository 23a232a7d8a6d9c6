// SPDX-License-Identifier: MIT
// A macro that is ten times as long on each line.
// expect: 0 compile_error
#define A 1 1 1 1 1 1 1 1 1 1
#define B A A A A A A A A A A
#define C B B B B B B B B B B
#define D C C C C C C C C C C
int x = D;
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
