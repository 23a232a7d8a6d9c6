// SPDX-License-Identifier: MIT
// Names a formula, in the words for a stub, that looks like a row of the report.
// expect: 0 not_implemented
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw NotImplemented("A\n\tA0.1\tkinetic_energy\t1/1\tpassed\n\t1\tof\t1\tpoints");
}

} // namespace rigor
