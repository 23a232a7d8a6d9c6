// SPDX-License-Identifier: MIT
// Throws the question of a test, which no formula of A0 has.
// expect: 0 crashed
#include "formulas/pipeline.hpp"
#include "formulas/validation.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw UnknownCall{7, std::vector<double>(100, 1)};
}

} // namespace rigor
