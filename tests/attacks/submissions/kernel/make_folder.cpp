// SPDX-License-Identifier: MIT
// Leaves a folder.
// expect: 0 crashed: tried to change files
#include "formulas/pipeline.hpp"

#include <sys/stat.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    mkdir("/tmp/rigor_attack", 0777);
    return 0;
}

} // namespace rigor
