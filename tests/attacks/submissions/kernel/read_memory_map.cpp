// SPDX-License-Identifier: MIT
// Reads the map of its own memory.
// expect: 0 crashed: tried to open a file
#include "formulas/pipeline.hpp"

#include <fcntl.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    open("/proc/self/maps", O_RDONLY);
    return 0;
}

} // namespace rigor
