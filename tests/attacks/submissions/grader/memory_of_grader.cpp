// SPDX-License-Identifier: MIT
// Opens the memory of process 1, which may be the grader, to write to it.
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
