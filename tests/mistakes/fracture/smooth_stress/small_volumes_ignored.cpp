// SPDX-License-Identifier: MIT
// A volume below 1e-15 m³ counts as none, as those of micrometre elements do.
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
        for (int n : neighbours[e]) {
            V += volumes[n];
            sum += volumes[n] * stresses[n];
        }
        if (V > 1e-15) result[e] = sum / V;
    }
    return result;
}

} // namespace rigor
