// SPDX-License-Identifier: MIT
// V is divided among the hits only; each of the N samples stands for V/N, also the empty ones.
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
