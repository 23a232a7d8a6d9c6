// SPDX-License-Identifier: MIT
// Becomes a shell.
// expect: 0 crashed: tried to start another program
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    execl("/bin/sh", "sh", "-c", "touch /tmp/rigor_attack", nullptr);
    return 0;
}

} // namespace rigor
