// SPDX-License-Identifier: MIT
// A formula that enters an endless loop in the middle of a scene, at its hundredth call.
#include "formulas/rotation.hpp"

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    static int calls = 0;
    if (++calls < 100) return {mass * gravity, Vector3d::Zero()};
    for (volatile unsigned i = 0;; i = i + 1) {
    }
}

} // namespace rigor
