// SPDX-License-Identifier: MIT
// A point whose distance from the axis is 1e-12 of its distance from X counts as on the axis.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x)
{
    const Vector3d r = x - X, turn = omega.cross(r);
    return turn.norm() <= 1e-12 * omega.norm() * r.norm() ? V : V + turn;
}

} // namespace rigor
