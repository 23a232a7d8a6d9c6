// SPDX-License-Identifier: MIT
// Leaves System V shared memory.
// expect: 0 crashed: tried to share memory with other processes
#include "formulas/pipeline.hpp"

#include <sys/ipc.h>
#include <sys/shm.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    shmget(0x7269676f, 4096, IPC_CREAT | 0666);
    return 0;
}

} // namespace rigor
