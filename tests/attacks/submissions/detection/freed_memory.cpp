// SPDX-License-Identifier: MIT
// Allocates what the worker has freed, and looks in it for answers that are not its own.
// expect: 0 failed
#include "formulas/pipeline.hpp"

#include <cstdlib>
#include <vector>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    double answer = 0;
    std::vector<void*> taken;
    taken.reserve(512);
    for (int size = 8; size < 4096; size += 8) {
        taken.push_back(std::malloc(size));
        if (!taken.back()) break;
        const double old = *static_cast<volatile double*>(taken.back());
        if (old > 0.1 && old < 1e4) answer = old;
    }
    for (void* block : taken)
        std::free(block);
    return answer;
}

} // namespace rigor
