// SPDX-License-Identifier: MIT
// Doubles a piece of memory without end, by moving it.
// expect: 0 crashed|failed
#include "formulas/pipeline.hpp"

#include <cstdlib>
#include <cstring>
#include <sys/mman.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    std::size_t size = 1 << 20;
    void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    for (void* larger = memory; larger != MAP_FAILED; size *= 2) {
        memory = larger;
        std::memset(memory, 1, size);
        larger = mremap(memory, size, 2 * size, MREMAP_MAYMOVE);
    }
    std::abort();
}

} // namespace rigor
