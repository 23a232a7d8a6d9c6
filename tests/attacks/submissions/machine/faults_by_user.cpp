// SPDX-License-Identifier: MIT
// Asks to handle page faults itself, with which it could stop the kernel at a place that it
// chooses.
// expect: 0 crashed: tried to make system call
#include "formulas/pipeline.hpp"

#include <sys/syscall.h>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    syscall(SYS_userfaultfd, 0);
    return 0;
}

} // namespace rigor
