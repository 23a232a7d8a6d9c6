// SPDX-License-Identifier: MIT
// Gives the compiler options: a plugin, files to write, a target that no machine has.
// expect: 0 compile_error|passed
#pragma GCC optimize("plugin=/tmp/rigor_attack.so")
#pragma GCC optimize("dump-tree-all=/tmp/rigor_attack", "save-temps")
#pragma GCC optimize("profile-generate=/tmp/rigor_attack", "callgraph-info")
#pragma GCC target("arch=rigor_attack")
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor
