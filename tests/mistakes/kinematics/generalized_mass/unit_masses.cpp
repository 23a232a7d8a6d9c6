// SPDX-License-Identifier: MIT
// The factor mᵢ is missing: each particle counts with mass 1.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    Matrix6d result = Matrix6d::Zero();
    for (const Particle& particle : particles) {
        const Matrix36d S = velocity_modes(X, particle.position);
        result += S.transpose() * S;
    }
    return result;
}

} // namespace rigor
