// SPDX-License-Identifier: MIT
// A formula that returns NaN in the middle of a scene, from its hundredth call on.
#include "formulas/rotation.hpp"

#include <limits>

namespace rigor {

Wrench gravity_wrench(double mass, const Vector3d& gravity)
{
    static int calls = 0;
    if (++calls < 100) return {mass * gravity, Vector3d::Zero()};
    return {std::numeric_limits<double>::quiet_NaN() * gravity, Vector3d::Zero()};
}

} // namespace rigor
