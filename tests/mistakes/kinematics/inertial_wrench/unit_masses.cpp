// SPDX-License-Identifier: MIT
// The factor mᵢ is missing: each particle counts with mass 1.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d&,
                       const Vector3d& omega)
{
    Wrench sum;
    for (const Particle& particle : particles) {
        const Vector3d r = particle.position - X;
        const Vector3d f = omega.cross(omega.cross(r));
        sum.force += f;
        sum.torque += r.cross(f);
    }
    return sum;
}

} // namespace rigor
