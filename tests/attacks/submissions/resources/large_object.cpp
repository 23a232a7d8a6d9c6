// SPDX-License-Identifier: MIT
// An object of about 240 megabytes, which would stay beside the submission.
// expect: 0 compile_error: expected an object of at most 16 MB
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

asm(".data; .fill 0x3a00000, 4, 7; .text");
