// SPDX-License-Identifier: MIT
// Lies in a section that can be written and executed. The formula is right, so it counts.
// expect: 1 passed|compile_error
#include "formulas/pipeline.hpp"

namespace rigor {

[[gnu::section("rigor_attack,\"awx\",@progbits#")]] double
kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
               const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
