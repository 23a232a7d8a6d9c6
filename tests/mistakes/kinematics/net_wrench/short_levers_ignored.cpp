// SPDX-License-Identifier: MIT
// A lever of less than a millionth of the longest one gives no torque.
#include "formulas/kinematics.hpp"

#include <algorithm>

namespace rigor {

Wrench net_wrench(const std::vector<PointForce>& forces, const Vector3d& X)
{
    double longest = 0;
    for (const PointForce& at : forces)
        longest = std::max(longest, (at.point - X).norm());
    Wrench sum;
    for (const PointForce& at : forces) {
        sum.force += at.force;
        if ((at.point - X).norm() > 1e-6 * longest) sum.torque += (at.point - X).cross(at.force);
    }
    return sum;
}

} // namespace rigor
