// SPDX-License-Identifier: MIT
// Writes to the memory of the grader.
// expect: 0 crashed: tried to open a file
#include "formulas/pipeline.hpp"

#include <fcntl.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    open("/proc/1/mem", O_RDWR);
    return 0;
}

} // namespace rigor
