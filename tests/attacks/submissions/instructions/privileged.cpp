// SPDX-License-Identifier: MIT
// An instruction that only the kernel may use.
// expect: 0 crashed: segmentation fault
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    asm volatile("hlt");
    return 0;
}

} // namespace rigor
