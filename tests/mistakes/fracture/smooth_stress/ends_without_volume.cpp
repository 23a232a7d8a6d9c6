// SPDX-License-Identifier: MIT
// The average ends at a neighbor after which the volume is still 0, though others may follow.
#include "formulas/fracture.hpp"

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<Matrix3d> result = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        double volume = volumes[e];
        Matrix3d sum = volumes[e] * stresses[e];
        for (const int m : neighbours[e]) {
            volume += volumes[m];
            if (volume == 0) break;
            sum += volumes[m] * stresses[m];
        }
        if (volume > 0) result[e] = sum / volume;
    }
    return result;
}

} // namespace rigor
