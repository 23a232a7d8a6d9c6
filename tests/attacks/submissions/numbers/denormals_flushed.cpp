// SPDX-License-Identifier: MIT
// A right formula that leaves the processor flushing small numbers to zero.
// expect: 1 passed
#include "formulas/pipeline.hpp"

#include <immintrin.h>

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    _mm_setcsr(_mm_getcsr() | 0x8040);
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
