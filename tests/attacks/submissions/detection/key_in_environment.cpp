// SPDX-License-Identifier: MIT
// Looks for the key of the random cases in its environment, and is right if it is there.
// expect: 0 failed
#include "formulas/pipeline.hpp"

#include <unistd.h>

extern char** environ;

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    if (environ[0] == nullptr) return 0;
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
