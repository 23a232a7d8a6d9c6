// SPDX-License-Identifier: MIT
// Asks for kernel namespaces of its own.
// expect: 0 crashed: tried to change mounts or namespaces
#include "formulas/pipeline.hpp"

#include <sched.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    unshare(CLONE_NEWUSER | CLONE_NEWNS);
    return 0;
}

} // namespace rigor
