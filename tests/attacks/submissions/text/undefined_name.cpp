// SPDX-License-Identifier: MIT
// Uses a function whose linker name clears a terminal.
// expect: 0 compile_error: invalid character
#include "formulas/pipeline.hpp"

extern "C" double lost(double) asm("\033[2Jlost");

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    return lost(1);
}

} // namespace rigor
