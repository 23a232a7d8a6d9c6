// SPDX-License-Identifier: MIT
// Asks for an io_uring, by which the kernel makes calls that no filter sees.
// expect: 0 crashed: tried to make system call
#include "formulas/pipeline.hpp"

#include <sys/syscall.h>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    char parameters[256] = {};
    syscall(SYS_io_uring_setup, 4, parameters);
    return 0;
}

} // namespace rigor
