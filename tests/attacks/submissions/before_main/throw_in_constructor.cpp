// SPDX-License-Identifier: MIT
// A global object whose constructor throws.
// expect: 0 compile_error: crashes (Aborted) before any function
#include "formulas/pipeline.hpp"

namespace {

struct Thrower {
    Thrower() { throw 1; }
} thrower;

} // namespace

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
