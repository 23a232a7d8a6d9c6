// SPDX-License-Identifier: MIT
// Leaves a file.
// expect: 0 crashed: tried to open a file
#include "formulas/pipeline.hpp"

#include <fcntl.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    open("/tmp/rigor_attack", O_CREAT | O_WRONLY, 0666);
    return 0;
}

} // namespace rigor
