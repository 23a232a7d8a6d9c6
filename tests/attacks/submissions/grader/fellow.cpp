// SPDX-License-Identifier: MIT
// Opens the worker of another student by its name.
// expect: 0 crashed: tried to open a file
#include "formulas/pipeline.hpp"

#include <fcntl.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    open("../0123456789abcdef/worker", O_RDONLY);
    return 0;
}

} // namespace rigor
