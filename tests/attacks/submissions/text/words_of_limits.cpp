// SPDX-License-Identifier: MIT
// Has the words of a compiler that ran out of memory or time in its own lines. The message shows
// the error and blames no limit.
// expect: 0 compile_error: of memory or not
#include "formulas/pipeline.hpp"

#include <new>

#error of memory or not: out of memory, memory exhausted, CPU time limit exceeded

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d&, const Vector3d&)
{
    try {
        return 0.5 * mass * velocity.squaredNorm();
    } catch (const std::bad_alloc& failure) {
        retrun 0;
    }
}

} // namespace rigor
