// SPDX-License-Identifier: MIT
// Equal forces count only once.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    Wrench sum;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        bool is_known = false;
        for (std::size_t k = 0; k < i; ++k)
            is_known |= forces[k].force == forces[i].force && forces[k].point == forces[i].point;
        if (is_known) continue;
        sum.force += forces[i].force;
        sum.torque += (forces[i].point - X).cross(forces[i].force);
    }
    return sum;
}

} // namespace rigor
