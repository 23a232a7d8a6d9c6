// SPDX-License-Identifier: MIT
// Asks for a higher priority.
// expect: 0 crashed: tried to change how it is scheduled
#include "formulas/pipeline.hpp"

#include <sys/resource.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    setpriority(PRIO_PROCESS, 0, -20);
    return 0;
}

} // namespace rigor
