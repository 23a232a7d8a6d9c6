// SPDX-License-Identifier: MIT
// A weak main function beside the worker's.
// expect: 1 passed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

[[gnu::weak]] int main()
{
    return 0;
}
