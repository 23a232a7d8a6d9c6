// SPDX-License-Identifier: MIT
// A constructor creates a timer, which could send signals without end.
// expect: 0 compile_error: before any function is called
#include "formulas/pipeline.hpp"

#include <csignal>
#include <ctime>

namespace {

[[gnu::constructor]] void start_clock()
{
    sigevent event = {};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGUSR1;
    timer_t clock = {};
    timer_create(CLOCK_MONOTONIC, &event, &clock);
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
