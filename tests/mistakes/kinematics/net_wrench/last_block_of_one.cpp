// SPDX-License-Identifier: MIT
// Forces are added in blocks of 300; a last block of a single force is lost.
#include "formulas/kinematics.hpp"

#include <algorithm>

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    constexpr std::size_t block = 300;
    Wrench result;
    for (std::size_t first = 0; first < forces.size(); first += block) {
        if (first > 0 && first + 1 == forces.size()) break;
        for (std::size_t i = first; i < std::min(first + block, forces.size()); ++i) {
            result.force += forces[i].force;
            result.torque += (forces[i].point - X).cross(forces[i].force);
        }
    }
    return result;
}

} // namespace rigor
