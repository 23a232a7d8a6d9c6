// SPDX-License-Identifier: MIT
// Includes a file of another user, so that the compiler's message tells whether it is there.
// expect: 0 compile_error: /root/.bashrc
#include "formulas/pipeline.hpp"

#include "/root/.bashrc"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
