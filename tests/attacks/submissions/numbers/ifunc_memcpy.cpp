// SPDX-License-Identifier: MIT
// A memcpy that copies nothing and is chosen by a resolver. The worker must not use it for its
// answers.
// expect: 1 passed
#include "formulas/pipeline.hpp"

extern "C" void* copy_nothing(void* to, const void*, unsigned long)
{
    return to;
}

extern "C" void* choose()
{
    return reinterpret_cast<void*>(&copy_nothing);
}

extern "C" [[gnu::ifunc("choose")]] void* memcpy(void*, const void*, unsigned long);

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
