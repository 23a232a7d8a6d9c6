// SPDX-License-Identifier: MIT
// Leaves a System V semaphore.
// expect: 0 crashed: tried to share memory with other processes
#include "formulas/pipeline.hpp"

#include <sys/ipc.h>
#include <sys/sem.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    semget(0x7269676f, 1, IPC_CREAT | 0666);
    return 0;
}

} // namespace rigor
