// SPDX-License-Identifier: MIT
// Copies a descriptor.
// expect: 0 crashed: tried to make a pipe or copy a descriptor
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    dup(1);
    return 0;
}

} // namespace rigor
