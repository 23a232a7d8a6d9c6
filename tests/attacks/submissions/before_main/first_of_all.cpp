// SPDX-License-Identifier: MIT
// An object that is constructed before those of the C++ library, and traps.
// expect: 0 compile_error: before any function is called
#include "formulas/pipeline.hpp"

namespace {

struct First {
    First() { __builtin_trap(); }
};
[[gnu::init_priority(101)]] First first;

} // namespace

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
