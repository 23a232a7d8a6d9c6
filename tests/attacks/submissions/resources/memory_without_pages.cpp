// SPDX-License-Identifier: MIT
// Asks for 2^48 addresses, twice as many as there are, and uses none of them.
// expect: 0 crashed|failed
#include "formulas/pipeline.hpp"

#include <sys/mman.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    for (int i = 0; i < 1 << 8; ++i)
        mmap(nullptr, 1ul << 40, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    return 0;
}

} // namespace rigor
