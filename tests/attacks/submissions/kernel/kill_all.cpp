// SPDX-License-Identifier: MIT
// Sends a signal to every process.
// expect: 0 crashed: tried to send a signal to a process
#include "formulas/pipeline.hpp"

#include <csignal>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    kill(-1, SIGKILL);
    return 0;
}

} // namespace rigor
