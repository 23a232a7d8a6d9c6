// SPDX-License-Identifier: MIT
// A constructor raises the limits of the process, which quietly fails.
// expect: 1 passed
#include "formulas/pipeline.hpp"

#include <sys/resource.h>

namespace {

[[gnu::constructor]] void ask_for_more()
{
    const rlimit more = {RLIM_INFINITY, RLIM_INFINITY};
    for (const auto resource : {RLIMIT_AS, RLIMIT_NPROC, RLIMIT_FSIZE, RLIMIT_CPU})
        setrlimit(resource, &more);
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
