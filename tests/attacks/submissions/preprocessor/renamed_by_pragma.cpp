// SPDX-License-Identifier: MIT
// Lets a pragma give a declaration the name of the worker's table of formulas, to put another
// function there.
// expect: 0 compile_error|failed|crashed
#pragma redefine_extname table_of_ours rigor_formulas
#include "formulas/pipeline.hpp"

extern "C" void (*table_of_ours[])();

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    for (int i = 0; i < 64; ++i)
        table_of_ours[i] = nullptr;
    return 0;
}

} // namespace rigor
