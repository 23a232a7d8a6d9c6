// SPDX-License-Identifier: MIT
// Asks to become the parent of orphans and not to be ended with its parent; this quietly fails.
// expect: 1 passed
#include "formulas/pipeline.hpp"

#include <sys/prctl.h>

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    prctl(PR_SET_PDEATHSIG, 0);
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
