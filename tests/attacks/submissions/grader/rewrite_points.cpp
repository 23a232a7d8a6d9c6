// SPDX-License-Identifier: MIT
// Rewrites the table of points for the next submission.
// expect: 0 crashed: tried to open a file
#include "formulas/pipeline.hpp"

#include <fcntl.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    open("../../../../assignments/a0-pipeline/assignment.json", O_WRONLY | O_TRUNC);
    return 0;
}

} // namespace rigor
