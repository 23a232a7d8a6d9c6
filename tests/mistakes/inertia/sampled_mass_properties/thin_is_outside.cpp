// SPDX-License-Identifier: MIT
// A sample counts as outside if its density is small beside the largest one.
#include "formulas/inertia.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    double densest = 0;
    for (const auto& sample : samples)
        densest = std::max(densest, std::abs(sample.density));
    std::vector<Particle> particles;
    for (const auto& [position, density] : samples)
        if (std::abs(density) > 1e-6 * densest)
            particles.push_back({volume * density / static_cast<double>(samples.size()), position});
    return particle_mass_properties(particles);
}

} // namespace rigor
