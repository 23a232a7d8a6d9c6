// SPDX-License-Identifier: MIT
// A formula whose numbers stay finite, and become huge in the middle of a scene, from its hundredth
// call on.
#include "formulas/rotation.hpp"

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    static int calls = 0;
    if (++calls < 100) return {mass * gravity, Vector3d::Zero()};
    return {1e198 * gravity, Vector3d::Zero()};
}

} // namespace rigor
