// SPDX-License-Identifier: MIT
// Forces that cancel but for 1e-11 of their sizes count as balanced.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench sum;
    double sizes = 0;
    for (const PointForce& at : forces) {
        sum.force += at.force;
        sum.torque += (at.point - X).cross(at.force);
        sizes += at.force.norm();
    }
    if (sum.force.norm() < 1e-11 * sizes) sum.force.setZero();
    return sum;
}

} // namespace rigor
