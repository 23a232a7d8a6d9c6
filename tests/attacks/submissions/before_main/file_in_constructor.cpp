// SPDX-License-Identifier: MIT
// A constructor opens a file of the system.
// expect: 0 compile_error: tries to open a file before any function
#include "formulas/pipeline.hpp"

#include <cstdio>

namespace {

[[gnu::constructor]] void look()
{
    if (std::FILE* file = std::fopen("/etc/passwd", "r")) std::fclose(file);
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
