// SPDX-License-Identifier: MIT
// An element among its own neighbors adds its stress once more, but not its volume.
#include "formulas/fracture.hpp"

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<Matrix3d> result = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        double V = volumes[e];
        for (int n : neighbours[e])
            V += n == static_cast<int>(e) ? 0 : volumes[n];
        if (V == 0) continue;
        result[e] = volumes[e] / V * stresses[e];
        for (int n : neighbours[e])
            result[e] += volumes[n] / V * stresses[n];
    }
    return result;
}

} // namespace rigor
