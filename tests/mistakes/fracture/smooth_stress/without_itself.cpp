// SPDX-License-Identifier: MIT
// The mean is over the neighbors only; the element itself is missing.
#include "formulas/fracture.hpp"

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<Matrix3d> result = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        double V = 0;
        Matrix3d sum = Matrix3d::Zero();
        for (int n : neighbours[e]) {
            V += volumes[n];
            sum += volumes[n] * stresses[n];
        }
        if (V > 0) result[e] = sum / V;
    }
    return result;
}

} // namespace rigor
