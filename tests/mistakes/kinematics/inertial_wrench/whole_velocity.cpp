// SPDX-License-Identifier: MIT
// The particle's own velocity takes the place of its velocity relative to X.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d& V,
                       const Vector3d& omega)
{
    Wrench sum;
    for (const Particle& particle : particles) {
        const Vector3d r = particle.position - X;
        const Vector3d f = particle.mass * omega.cross(omega.cross(r) + V);
        sum.force += f;
        sum.torque += r.cross(f);
    }
    return sum;
}

} // namespace rigor
