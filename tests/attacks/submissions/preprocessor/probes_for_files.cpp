// SPDX-License-Identifier: MIT
// Asks the preprocessor which files there are, and is right if it finds one of the framework.
// expect: 0 failed|compile_error
#include "formulas/pipeline.hpp"

namespace rigor {

constexpr int found =
#if __has_include("../../../../reference/pipeline.cpp")
    1 +
#endif
#if __has_include("../../../../tests/graded/hidden/kinematics_test.cpp")
    1 +
#endif
#if __has_include("/proc/self/environ")
    1 +
#endif
#if __has_include("/etc/shadow") || __has_include("/root/.bashrc")
    1 +
#endif
#if __has_include("../out/link/worker") || __has_include("../../student/files/pipeline.cpp")
    1 +
#endif
    0;

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    if (found == 0) return 0;
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
