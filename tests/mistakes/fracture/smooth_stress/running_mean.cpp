// SPDX-License-Identifier: MIT
// A running mean loses the digits of all others to a huge stress without volume.
#include "formulas/fracture.hpp"

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<Matrix3d> smoothed = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        double volume = volumes[e];
        for (const int m : neighbours[e]) {
            if (volumes[m] == 0) continue;
            volume += volumes[m];
            smoothed[e] += volumes[m] / volume * (stresses[m] - smoothed[e]);
        }
    }
    return smoothed;
}

} // namespace rigor
