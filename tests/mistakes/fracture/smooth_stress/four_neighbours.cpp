// SPDX-License-Identifier: MIT
// Only the first four neighbors count.
#include "formulas/fracture.hpp"

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<Matrix3d> result = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        double V = volumes[e];
        Matrix3d sum = V * stresses[e];
        for (std::size_t i = 0; i < neighbours[e].size() && i < 4; ++i) {
            V += volumes[neighbours[e][i]];
            sum += volumes[neighbours[e][i]] * stresses[neighbours[e][i]];
        }
        if (V > 0) result[e] = sum / V;
    }
    return result;
}

} // namespace rigor
