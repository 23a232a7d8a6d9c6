// SPDX-License-Identifier: MIT
// Equal particles count only once.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    Matrix6d sum = Matrix6d::Zero();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        bool is_known = false;
        for (std::size_t k = 0; k < i; ++k)
            is_known |= particles[k].mass == particles[i].mass &&
                        particles[k].position == particles[i].position;
        if (is_known) continue;
        const Matrix36d S = velocity_modes(X, particles[i].position);
        sum += particles[i].mass * S.transpose() * S;
    }
    return sum;
}

} // namespace rigor
