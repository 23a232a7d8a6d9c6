// SPDX-License-Identifier: MIT
// A formula that leaves all traps of the floating-point unit switched on.
// expect: 0 crashed: arithmetic exception
#include "formulas/pipeline.hpp"

#include <immintrin.h>

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    _mm_setcsr(_mm_getcsr() & ~0x1f80u);
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
