// SPDX-License-Identifier: MIT
// Leaves the direction flag set, so that copies run backwards.
// expect: 0 crashed|timed_out|failed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    asm volatile("std");
    return 0;
}

} // namespace rigor
