// SPDX-License-Identifier: MIT
// Calls itself without end.
// expect: 0 crashed: segmentation fault
#include "formulas/pipeline.hpp"

namespace {

double deeper(double x)
{
    volatile double here[64] = {x};
    return deeper(x + here[0]) + here[0];
}

} // namespace

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    return deeper(1);
}

} // namespace rigor
