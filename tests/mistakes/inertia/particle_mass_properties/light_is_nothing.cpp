// SPDX-License-Identifier: MIT
// A swarm of less than 1e-9 kg counts as having no mass.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    MassProperties all;
    for (const Particle& particle : particles) {
        all.mass += particle.mass;
        all.center_of_mass += particle.mass * particle.position;
    }
    if (all.mass < 1e-9) return {};
    all.center_of_mass /= all.mass;
    for (const Particle& particle : particles) {
        const Vector3d d = particle.position - all.center_of_mass;
        all.inertia += particle.mass * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    return all;
}

} // namespace rigor
