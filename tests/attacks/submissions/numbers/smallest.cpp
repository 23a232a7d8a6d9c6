// SPDX-License-Identifier: MIT
// The smallest number, which is no energy of anything.
// expect: 0 failed
#include "formulas/pipeline.hpp"

#include <limits>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    return std::numeric_limits<double>::denorm_min();
}

} // namespace rigor
