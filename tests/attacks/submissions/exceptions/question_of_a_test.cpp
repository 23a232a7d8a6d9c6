// SPDX-License-Identifier: MIT
// Throws UnknownCall, by which the tests of A8 ask for a result. No formula of A0 may do so.
// expect: 0 crashed
#include "formulas/pipeline.hpp"
#include "formulas/validation.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw UnknownCall{7, std::vector<double>(100, 1)};
}

} // namespace rigor
