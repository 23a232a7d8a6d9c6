// SPDX-License-Identifier: MIT
// Leaves a System V message queue.
// expect: 0 crashed: tried to share memory with other processes
#include "formulas/pipeline.hpp"

#include <sys/ipc.h>
#include <sys/msg.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    msgget(0x7269676f, IPC_CREAT | 0666);
    return 0;
}

} // namespace rigor
