// SPDX-License-Identifier: MIT
// A constructor ignores every signal that can be ignored.
// expect: 1 passed
#include "formulas/pipeline.hpp"

#include <csignal>

namespace {

[[gnu::constructor]] void be_deaf()
{
    for (int signal = 1; signal < 32; ++signal)
        std::signal(signal, SIG_IGN);
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
