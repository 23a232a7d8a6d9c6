// SPDX-License-Identifier: MIT
// Cells with less than a thousandth of the highest density are left out.
#include "formulas/inertia.hpp"

#include <algorithm>

namespace rigor {

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    double densest = 0;
    for (const DensitySample& sample : samples)
        densest = std::max(densest, sample.density);
    std::vector<Particle> particles;
    for (const auto& [position, density] : samples)
        if (density >= 1e-3 * densest)
            particles.push_back({density * cell_size * cell_size * cell_size, position});
    return particle_mass_properties(particles);
}

} // namespace rigor
