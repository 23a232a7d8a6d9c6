// SPDX-License-Identifier: MIT
// Stops its parent by a signal, so that the grading would never end.
// expect: 0 crashed: tried to
#include "formulas/pipeline.hpp"

#include <csignal>
#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    kill(getppid(), SIGSTOP);
    return 0;
}

} // namespace rigor
