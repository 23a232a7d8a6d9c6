// SPDX-License-Identifier: MIT
// An infinite result.
// expect: 0 not_finite
#include "formulas/pipeline.hpp"

#include <limits>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    return std::numeric_limits<double>::infinity();
}

} // namespace rigor
