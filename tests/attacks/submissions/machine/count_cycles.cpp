// SPDX-License-Identifier: MIT
// Asks for a performance counter of the processor, which tells about other processes.
// expect: 0 crashed: tried to make system call
#include "formulas/pipeline.hpp"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    perf_event_attr attributes = {};
    syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0);
    return 0;
}

} // namespace rigor
