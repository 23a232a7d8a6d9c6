// SPDX-License-Identifier: MIT
// A single particle is returned as it is, even if it has no mass.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    if (particles.size() == 1) return {particles[0].mass, particles[0].position, Matrix3d::Zero()};
    MassProperties result;
    for (const auto& [m, p] : particles) {
        result.mass += m;
        result.center_of_mass += m * p;
    }
    if (result.mass == 0) return {};
    result.center_of_mass /= result.mass;
    for (const auto& [m, p] : particles) {
        const Vector3d d = p - result.center_of_mass;
        result.inertia += m * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    return result;
}

} // namespace rigor
