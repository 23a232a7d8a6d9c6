// SPDX-License-Identifier: MIT
// Leaves POSIX shared memory, which has a name.
// expect: 0 crashed: tried to open a file
#include "formulas/pipeline.hpp"

#include <fcntl.h>
#include <sys/mman.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    shm_open("/rigor_attack", O_CREAT | O_RDWR, 0666);
    return 0;
}

} // namespace rigor
