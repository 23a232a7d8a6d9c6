// SPDX-License-Identifier: MIT
// A couple has the same torque about every point, so it is computed about the origin, where it
// loses its digits if the body is far away.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench result;
    for (const PointForce& force : forces)
        result.force += force.force;
    const Vector3d about = result.force.isZero(0) ? Vector3d(0, 0, 0) : X;
    for (const PointForce& force : forces)
        result.torque += (force.point - about).cross(force.force);
    return result;
}

} // namespace rigor
