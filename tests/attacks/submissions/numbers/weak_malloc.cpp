// SPDX-License-Identifier: MIT
// A weak malloc that has no memory. The worker must not use it.
// expect: 1 passed
#include "formulas/pipeline.hpp"

extern "C" [[gnu::weak]] void* malloc(unsigned long)
{
    return nullptr;
}

extern "C" [[gnu::weak]] void free(void*) {}

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
