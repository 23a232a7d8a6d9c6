// SPDX-License-Identifier: MIT
// Without the transpose of X* - x* the torque is reversed: τ = Σ (xᵢ - X) × fᵢ.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench result;
    for (const PointForce& at : forces) {
        result.force += at.force;
        result.torque += (X - at.point).cross(at.force);
    }
    return result;
}

} // namespace rigor
