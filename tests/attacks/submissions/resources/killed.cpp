// SPDX-License-Identifier: MIT
// Kills its own process as the kernel does when memory is short.
// expect: 0 crashed: killed
#include "formulas/pipeline.hpp"

#include <csignal>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    raise(SIGKILL);
    return 0;
}

} // namespace rigor
