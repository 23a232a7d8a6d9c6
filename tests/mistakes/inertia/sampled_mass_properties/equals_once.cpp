// SPDX-License-Identifier: MIT
// A sample at a place that was drawn before counts only once.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    std::vector<DensitySample> others;
    for (const DensitySample& sample : samples) {
        bool is_known = false;
        for (const DensitySample& other : others)
            is_known |= other.position == sample.position;
        if (!is_known) others.push_back(sample);
    }
    std::vector<Particle> particles;
    for (const auto& [position, density] : others)
        particles.push_back({density * volume / static_cast<double>(others.size()), position});
    return particle_mass_properties(particles);
}

} // namespace rigor
