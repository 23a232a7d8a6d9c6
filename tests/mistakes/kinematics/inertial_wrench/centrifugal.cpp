// SPDX-License-Identifier: MIT
// The acceleration points to the axis. This is the centrifugal force of a turning frame.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d&,
                       const Vector3d& omega)
{
    Wrench sum;
    for (const Particle& particle : particles) {
        const Vector3d r = particle.position - X;
        const Vector3d f = -particle.mass * omega.cross(omega.cross(r));
        sum.force += f;
        sum.torque += r.cross(f);
    }
    return sum;
}

} // namespace rigor
