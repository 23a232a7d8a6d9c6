// SPDX-License-Identifier: MIT
// Leaves a key in the kernel.
// expect: 0 crashed: tried to make system call
#include "formulas/pipeline.hpp"

#include <sys/syscall.h>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    syscall(SYS_add_key, "user", "rigor_attack", "x", 1, -3);
    return 0;
}

} // namespace rigor
