// SPDX-License-Identifier: MIT
// Leaves a process that outlives the grading.
// expect: 0 crashed: tried to
#include "formulas/pipeline.hpp"

#include <unistd.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    if (fork() == 0 && setsid() > 0 && fork() == 0) sleep(60);
    return 0;
}

} // namespace rigor
