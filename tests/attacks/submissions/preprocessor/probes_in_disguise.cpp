// SPDX-License-Identifier: MIT
// Asks the preprocessor for a file that is there on each machine, by every spelling of the
// question, and is right if one of them gets the answer yes.
// expect: 0 failed
#include "formulas/pipeline.hpp"

// clang-format off
#define PASTED(a, b) a##b
#define ALIAS __has_include
#define LATER PASTED(__has_, include)
_Pragma("push_macro(\"__has_include\")")
_Pragma("pop_macro(\"__has_include\")")

namespace rigor {

constexpr int found =
#if __has_include("/usr/include/stdio.h") || __has_include(</usr/include/stdio.h>)
    1 +
#endif
#if __has_\
include("/usr/include/stdio.h")
    1 +
#endif
%:if PASTED(__has_, include)("/usr/include/stdio.h") or LATER("/usr/include/stdio.h")
    1 +
%:endif
#if ALIAS("/usr/include/stdio.h") || __has_include("../../../../../../../../../usr/include/stdio.h")
    1 +
#endif
#if __has_include_next(</usr/include/stdio.h>) || __has_include_next("/usr/include/stdio.h")
    1 +
#endif
#if __has_embed("/usr/include/stdio.h")
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
