// SPDX-License-Identifier: MIT
// Is right only if the compiler finds the reference. Without namespaces the
// compiler may not even look.
// expect: 0 failed|compile_error
#include "formulas/pipeline.hpp"

#if __has_include("../../../../../reference/pipeline.cpp") ||                                      \
                  __has_include("formulas/../../reference/pipeline.cpp")
constexpr double found = 1;
#else
constexpr double found = 0;
#endif

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return found * 0.5 * mass * velocity.squaredNorm() +
           found * 0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
