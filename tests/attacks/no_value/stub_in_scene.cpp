// SPDX-License-Identifier: MIT
// A formula that reports itself as not implemented in the middle of a scene.
#include "formulas/rotation.hpp"

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    static int calls = 0;
    if (++calls < 100) return {mass * gravity, Vector3d::Zero()};
    throw NotImplemented("rotation::gravity_wrench");
}

} // namespace rigor
