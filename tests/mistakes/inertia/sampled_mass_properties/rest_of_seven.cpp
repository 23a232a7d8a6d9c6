// SPDX-License-Identifier: MIT
// Blocks of 8, 4 and 2 samples are taken; where 7 are left over, the last one is forgotten.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    if (samples.empty()) return {};
    const std::size_t count = samples.size(), used = count % 8 == 7 ? count - 1 : count;
    std::vector<Particle> particles;
    for (std::size_t i = 0; i < used; ++i)
        particles.push_back(
            {samples[i].density * volume / static_cast<double>(count), samples[i].position});
    return particle_mass_properties(particles);
}

} // namespace rigor
