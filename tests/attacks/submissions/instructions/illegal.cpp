// SPDX-License-Identifier: MIT
// An instruction that does not exist.
// expect: 0 crashed: illegal instruction
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    __builtin_trap();
}

} // namespace rigor
