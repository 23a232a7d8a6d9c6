// SPDX-License-Identifier: MIT
// Asks to handle the faults of its memory itself, which stops the kernel where it wants.
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
