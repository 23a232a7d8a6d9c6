// SPDX-License-Identifier: MIT
// Stops its own process.
// expect: 0 crashed: stopped itself
#include "formulas/pipeline.hpp"

#include <csignal>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    raise(SIGSTOP);
    return 0;
}

} // namespace rigor
