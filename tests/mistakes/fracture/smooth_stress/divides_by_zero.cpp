// SPDX-License-Identifier: MIT
// If an element and its neighbors have no volume, the mean divides by zero.
#include "formulas/fracture.hpp"

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<Matrix3d> result = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        double V = volumes[e];
        Matrix3d sum = volumes[e] * stresses[e];
        for (int n : neighbours[e]) {
            V += volumes[n];
            sum += volumes[n] * stresses[n];
        }
        result[e] = sum / V;
    }
    return result;
}

} // namespace rigor
