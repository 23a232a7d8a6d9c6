// SPDX-License-Identifier: MIT
// Particles with less than a millionth of the mass are left out.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    double M = 0;
    for (const Particle& particle : particles)
        M += particle.mass;
    Matrix6d sum = Matrix6d::Zero();
    for (const Particle& particle : particles) {
        if (particle.mass < 1e-6 * M) continue;
        const Matrix36d S = velocity_modes(X, particle.position);
        sum += particle.mass * S.transpose() * S;
    }
    return sum;
}

} // namespace rigor
