// SPDX-License-Identifier: MIT
// Prints without end.
// expect: 0 crashed: printed more than 1024 kB
#include "formulas/pipeline.hpp"

#include <cstdio>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    for (;;)
        std::puts("I am still here");
}

} // namespace rigor
