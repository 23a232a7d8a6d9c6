// SPDX-License-Identifier: MIT
// A signalling NaN, which traps if a program has switched the trap on.
// expect: 0 not_finite
#include "formulas/pipeline.hpp"

#include <limits>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    return std::numeric_limits<double>::signaling_NaN();
}

} // namespace rigor
