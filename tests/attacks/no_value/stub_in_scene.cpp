// SPDX-License-Identifier: MIT
// Is not finished.
#include "formulas/rotation.hpp"

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    static int calls = 0;
    if (++calls < 100) return {mass * gravity, Vector3d::Zero()};
    throw NotImplemented("rotation::gravity_wrench");
}

} // namespace rigor
