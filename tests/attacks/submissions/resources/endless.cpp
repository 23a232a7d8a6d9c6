// SPDX-License-Identifier: MIT
// Never returns.
// expect: 0 timed_out: did not return
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    for (volatile unsigned i = 0;; i = i + 1) {
    }
}

} // namespace rigor
