// SPDX-License-Identifier: MIT
// A formula whose resolver never ends, so that the program does not start.
// expect: 0 compile_error: does not return before any function is called
#include "formulas/pipeline.hpp"

extern "C" void* choose()
{
    for (volatile unsigned i = 0;; i = i + 1) {
    }
}

namespace rigor {

[[gnu::ifunc("choose")]] double kinetic_energy(double, const Vector3d&, const Matrix3d&,
                                               const Vector3d&);

} // namespace rigor
