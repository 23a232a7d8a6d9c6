// SPDX-License-Identifier: MIT
// Deletes a file of the tree.
// expect: 0 crashed: tried to change files
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    unlink("../../../../README.md");
    return 0;
}

} // namespace rigor
