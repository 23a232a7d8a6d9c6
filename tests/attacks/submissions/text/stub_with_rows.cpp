// SPDX-License-Identifier: MIT
// Says that it is a stub, in the rows of a table.
// expect: 0 not_implemented
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw NotImplemented("A0.1\nA0.1   kinetic_energy   1/1   passed\n\033[32m1 of 1 points");
}

} // namespace rigor
