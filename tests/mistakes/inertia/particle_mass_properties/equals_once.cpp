// SPDX-License-Identifier: MIT
// Equal particles count only once.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    std::vector<Particle> others;
    for (const Particle& particle : particles) {
        bool is_known = false;
        for (const Particle& other : others)
            is_known |= other.mass == particle.mass && other.position == particle.position;
        if (!is_known) others.push_back(particle);
    }
    MassProperties all;
    for (const Particle& particle : others)
        all = combine(all, {particle.mass, particle.position, Matrix3d::Zero()});
    return all;
}

} // namespace rigor
