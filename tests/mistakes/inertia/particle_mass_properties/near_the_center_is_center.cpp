// SPDX-License-Identifier: MIT
// Particles within a millionth of the extent from the center have no inertia.
#include "formulas/inertia.hpp"

#include <algorithm>

namespace rigor {

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    double M = 0;
    Vector3d X = Vector3d::Zero();
    for (const auto& [m, p] : particles) {
        M += m;
        X += m * p;
    }
    if (M == 0) return {};
    X /= M;
    double extent = 0;
    for (const Particle& particle : particles)
        extent = std::max(extent, (particle.position - X).norm());
    Matrix3d I = Matrix3d::Zero();
    for (const auto& [m, p] : particles) {
        const Vector3d d = p - X;
        if (d.norm() < 1e-6 * extent) continue;
        I += m * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    return {M, X, I};
}

} // namespace rigor
