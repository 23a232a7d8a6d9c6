// SPDX-License-Identifier: MIT
// The smoothing works in place, so an element sees neighbors that are already smoothed.
#include "formulas/fracture.hpp"

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<Matrix3d> result = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        double V = volumes[e];
        Matrix3d sum = volumes[e] * result[e];
        for (int n : neighbours[e]) {
            V += volumes[n];
            sum += volumes[n] * result[n];
        }
        if (V > 0) result[e] = sum / V;
    }
    return result;
}

} // namespace rigor
