// SPDX-License-Identifier: MIT
// The smallest positive double, which is not the energy of any body.
// expect: 0 failed
#include "formulas/pipeline.hpp"

#include <limits>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    return std::numeric_limits<double>::denorm_min();
}

} // namespace rigor
