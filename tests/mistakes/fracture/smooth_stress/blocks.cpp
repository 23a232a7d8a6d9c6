// SPDX-License-Identifier: MIT
// Averages 4096 elements at a time; the next ones find averages among their neighbours.
#include "formulas/fracture.hpp"

#include <algorithm>

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    constexpr std::size_t block = 4096; // stays in the cache
    std::vector<Matrix3d> smoothed = stresses, averages(std::min(block, stresses.size()));
    for (std::size_t first = 0; first < stresses.size(); first += block) {
        const std::size_t last = std::min(first + block, stresses.size());
        for (std::size_t e = first; e < last; ++e) {
            Matrix3d sum = volumes[e] * smoothed[e];
            double volume = volumes[e];
            for (const int m : neighbours[e]) {
                sum += volumes[m] * smoothed[m];
                volume += volumes[m];
            }
            averages[e - first] = volume > 0 ? Matrix3d(sum / volume) : smoothed[e];
        }
        std::copy_n(averages.begin(), last - first, smoothed.begin() + static_cast<long>(first));
    }
    return smoothed;
}

} // namespace rigor
