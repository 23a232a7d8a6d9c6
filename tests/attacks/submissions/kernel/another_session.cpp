// SPDX-License-Identifier: MIT
// Leaves its session.
// expect: 0 crashed: tried to leave its session
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    setsid();
    return 0;
}

} // namespace rigor
