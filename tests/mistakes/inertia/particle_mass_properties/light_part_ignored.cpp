// SPDX-License-Identifier: MIT
// Particles with less than a billionth of the heaviest one are left out.
#include "formulas/inertia.hpp"

#include <algorithm>

namespace rigor {

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    double heaviest = 0;
    for (const Particle& particle : particles)
        heaviest = std::max(heaviest, particle.mass);
    MassProperties all;
    for (const Particle& particle : particles)
        if (particle.mass >= 1e-9 * heaviest)
            all = combine(all, {particle.mass, particle.position, Matrix3d::Zero()});
    return all;
}

} // namespace rigor
