// SPDX-License-Identifier: MIT
// Undefines the macro that answers each __has_include with no, to ask the compiler itself.
// expect: 0 compile_error
#include "formulas/pipeline.hpp"

#undef __has_include

#if __has_include("/usr/include/stdio.h")
constexpr double found = 1;
#else
constexpr double found = 0;
#endif

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return found * (0.5 * mass * velocity.squaredNorm() +
                    0.5 * angular_velocity.dot(inertia * angular_velocity));
}

} // namespace rigor
