// SPDX-License-Identifier: MIT
// Reads the memory of process 1.
// expect: 0 crashed: tried to look into another process
#include "formulas/pipeline.hpp"

#include <sys/uio.h>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    char byte = 0;
    const iovec here = {&byte, 1}, there = {nullptr, 1};
    process_vm_readv(1, &here, 1, &there, 1, 0);
    return 0;
}

} // namespace rigor
