// SPDX-License-Identifier: MIT
// An operator new that throws. The build makes it local to this file.
// expect: 1 passed
#include "formulas/pipeline.hpp"

#include <new>

void* operator new(std::size_t)
{
    throw std::bad_alloc();
}

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
