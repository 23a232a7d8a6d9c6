// SPDX-License-Identifier: MIT
// The torque is about the origin; it must be about X, with the lever arm xᵢ - X.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench result;
    for (const PointForce& at : forces) {
        result.force += at.force;
        result.torque += at.point.cross(at.force);
    }
    return result;
}

} // namespace rigor
