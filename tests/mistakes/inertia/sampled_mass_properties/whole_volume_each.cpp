// SPDX-License-Identifier: MIT
// Each sample counts with the whole volume V; it stands for V/N.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    std::vector<Particle> points;
    for (const DensitySample& sample : samples)
        points.push_back({sample.density * volume, sample.position});
    return particle_mass_properties(points);
}

} // namespace rigor
