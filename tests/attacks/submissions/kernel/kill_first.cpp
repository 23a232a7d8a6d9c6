// SPDX-License-Identifier: MIT
// Sends a signal to a thread of process 1.
// expect: 0 crashed: tried to send a signal to a process
#include "formulas/pipeline.hpp"

#include <csignal>
#include <sys/syscall.h>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    syscall(SYS_tgkill, 1, 1, SIGKILL);
    return 0;
}

} // namespace rigor
