// SPDX-License-Identifier: MIT
// Gives the names of the contract other meanings, by macros. Then the formula is not defined.
// expect: 0 compile_error: kinetic_energy
#include "formulas/pipeline.hpp"

namespace theirs = rigor;

#define rigor other

namespace rigor {
using theirs::Matrix3d;
using theirs::Vector3d;
} // namespace rigor

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
