// SPDX-License-Identifier: MIT
// A right formula that leaves every flag of the floating-point unit raised.
// expect: 1 passed
#include "formulas/pipeline.hpp"

#include <cfenv>

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    std::feraiseexcept(FE_ALL_EXCEPT);
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
