// SPDX-License-Identifier: MIT
// Particles of less than 1e-12 of the heaviest are left out, however far away they are.
#include "formulas/kinematics.hpp"

#include <algorithm>

namespace rigor {

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    double heaviest = 0;
    for (const Particle& particle : particles)
        heaviest = std::max(heaviest, particle.mass);
    Matrix6d sum = Matrix6d::Zero();
    for (const Particle& particle : particles) {
        if (particle.mass < 1e-12 * heaviest) continue;
        const Matrix36d S = velocity_modes(X, particle.position);
        sum += particle.mass * S.transpose() * S;
    }
    return sum;
}

} // namespace rigor
