// SPDX-License-Identifier: MIT
// Makes a file in memory.
// expect: 0 crashed: tried to make a file in memory
#include "formulas/pipeline.hpp"

#include <sys/mman.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    memfd_create("rigor_attack", 0);
    return 0;
}

} // namespace rigor
