// SPDX-License-Identifier: MIT
// The mean is not weighted by volume: a sliver counts as much as a large element.
#include "formulas/fracture.hpp"

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<Matrix3d> result = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        Matrix3d sum = stresses[e];
        for (int n : neighbours[e])
            sum += stresses[n];
        result[e] = sum / (1.0 + static_cast<double>(neighbours[e].size()));
    }
    return result;
}

} // namespace rigor
