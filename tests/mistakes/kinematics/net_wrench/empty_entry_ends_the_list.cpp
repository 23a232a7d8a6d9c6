// SPDX-License-Identifier: MIT
// An entry without a force at the origin is taken for the end of the list.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench net;
    for (const auto& [force, point] : forces) {
        if (force.isZero(0) && point.isZero(0)) break;
        net.force += force;
        net.torque += (point - X).cross(force);
    }
    return net;
}

} // namespace rigor
