// SPDX-License-Identifier: MIT
// Opens the standard output of its parent, to which it could write a verdict.
// expect: 0 crashed: tried to ask which process started it
#include "formulas/pipeline.hpp"

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    char path[64];
    std::snprintf(path, sizeof path, "/proc/%d/fd/1", getppid());
    open(path, O_WRONLY);
    return 0;
}

} // namespace rigor
