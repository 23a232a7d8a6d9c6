// SPDX-License-Identifier: MIT
// isZero() has an absolute precision of 1e-12, so a slow turn counts as none.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x)
{
    if (omega.isZero()) return V;
    return V + omega.cross(x - X);
}

} // namespace rigor
