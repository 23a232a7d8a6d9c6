// SPDX-License-Identifier: MIT
// Includes the input of the compiler, which is the empty device. Without
// namespaces it can be opened.
// expect: 0 compile_error|passed
#include "/dev/stdin"
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
