// SPDX-License-Identifier: MIT
// A point near the center of mass moves with it only if it is the center of mass itself.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x)
{
    if (x.isApprox(X)) return V; // the center itself
    return omega.cross(x - X) + V;
}

} // namespace rigor
