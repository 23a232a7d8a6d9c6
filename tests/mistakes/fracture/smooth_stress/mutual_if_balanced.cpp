// SPDX-License-Identifier: MIT
// If each element is named as often as it names others, all are taken to name those that name them.
#include "formulas/fracture.hpp"

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<std::vector<int>> named_by(stresses.size());
    for (std::size_t e = 0; e < stresses.size(); ++e)
        for (int n : neighbours[e])
            named_by[n].push_back(static_cast<int>(e));
    bool is_balanced = true;
    for (std::size_t e = 0; e < stresses.size(); ++e)
        is_balanced &= named_by[e].size() == neighbours[e].size();

    std::vector<Matrix3d> result = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        double V = volumes[e];
        Matrix3d sum = volumes[e] * stresses[e];
        for (int n : is_balanced ? named_by[e] : neighbours[e]) {
            V += volumes[n];
            sum += volumes[n] * stresses[n];
        }
        if (V > 0) result[e] = sum / V;
    }
    return result;
}

} // namespace rigor
