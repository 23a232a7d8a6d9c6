// SPDX-License-Identifier: MIT
// Looks for the reference in the folders above.
// expect: 0 crashed: tried to open a file
#include "formulas/pipeline.hpp"

#include <fcntl.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    open("../../../../reference/pipeline.cpp", O_RDONLY);
    return 0;
}

} // namespace rigor
