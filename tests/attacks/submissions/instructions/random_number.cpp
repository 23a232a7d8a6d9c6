// SPDX-License-Identifier: MIT
// Draws its answers from the random numbers of the processor (rdrand).
// expect: 0 failed|crashed
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    unsigned long bits = 0;
    asm volatile("rdrand %0" : "=r"(bits));
    return static_cast<double>(bits % 1000) / 16;
}

} // namespace rigor
