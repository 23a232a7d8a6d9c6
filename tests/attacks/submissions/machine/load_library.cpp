// SPDX-License-Identifier: MIT
// Loads a library while it runs.
// expect: 0 crashed|failed|compile_error
#include "formulas/pipeline.hpp"

#include <dlfcn.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    dlopen("/tmp/rigor_attack.so", RTLD_NOW);
    return 0;
}

} // namespace rigor
