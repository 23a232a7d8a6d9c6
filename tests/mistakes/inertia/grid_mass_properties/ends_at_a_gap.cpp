// SPDX-License-Identifier: MIT
// The first cell without density ends the sum.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    std::vector<Particle> particles;
    for (const auto& [position, density] : samples) {
        if (density == 0) break;
        particles.push_back({density * cell_size * cell_size * cell_size, position});
    }
    return particle_mass_properties(particles);
}

} // namespace rigor
