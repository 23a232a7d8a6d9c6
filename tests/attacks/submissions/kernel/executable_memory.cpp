// SPDX-License-Identifier: MIT
// Asks for memory that can be executed.
// expect: 0 crashed: tried to make memory executable
#include "formulas/pipeline.hpp"

#include <sys/mman.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    mmap(nullptr, 4096, PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return 0;
}

} // namespace rigor
