// SPDX-License-Identifier: MIT
// Shows control characters in a message of the compiler.
// expect: 0 compile_error
#include "formulas/pipeline.hpp"

static_assert(false, "\u202e \u2066 \u0085 \u009b31m \u2028 \ufeff");

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    return 0;
}

} // namespace rigor
