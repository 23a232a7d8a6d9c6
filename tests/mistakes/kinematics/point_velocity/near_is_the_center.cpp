// SPDX-License-Identifier: MIT
// A point nearer to X than a millionth of its distance from the origin counts as the center.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x)
{
    if (x.isApprox(X, 1e-6)) return V;
    return V + omega.cross(x - X);
}

} // namespace rigor
