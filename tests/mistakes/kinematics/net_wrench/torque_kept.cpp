// SPDX-License-Identifier: MIT
// The sum is kept between calls, and without a force it is not reset.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    static Wrench sum;
    if (!forces.empty()) sum = Wrench();
    sum.force.setZero();
    for (const auto& [force, point] : forces) {
        sum.force += force;
        sum.torque += (point - X).cross(force);
    }
    return sum;
}

} // namespace rigor
