// SPDX-License-Identifier: MIT
// A constructor opens a socket.
// expect: 0 compile_error: tries to open a network socket before any function
#include "formulas/pipeline.hpp"

#include <sys/socket.h>

namespace {

[[gnu::constructor]] void call_home()
{
    socket(AF_INET, SOCK_STREAM, 0);
}

} // namespace

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
