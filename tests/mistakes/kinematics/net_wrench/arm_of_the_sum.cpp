// SPDX-License-Identifier: MIT
// The net force is crossed with the sum of the lever arms; each force has its own arm.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench result;
    Vector3d arms = Vector3d::Zero();
    for (const PointForce& at : forces) {
        result.force += at.force;
        arms += at.point - X;
    }
    result.torque = arms.cross(result.force);
    return result;
}

} // namespace rigor
