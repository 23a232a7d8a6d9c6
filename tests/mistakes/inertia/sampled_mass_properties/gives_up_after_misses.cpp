// SPDX-License-Identifier: MIT
// If the first 256 samples miss the solid, there seems to be none.
#include "formulas/inertia.hpp"

#include <algorithm>

namespace rigor {

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    constexpr std::ptrdiff_t many = 256;
    if (std::ssize(samples) > many &&
        std::all_of(samples.begin(), samples.begin() + many,
                    [](const DensitySample& sample) { return sample.density == 0; }))
        return {};
    std::vector<Particle> points;
    for (const auto& [position, density] : samples)
        points.push_back({volume * density / static_cast<double>(samples.size()), position});
    return particle_mass_properties(points);
}

} // namespace rigor
