// SPDX-License-Identifier: MIT
// A volume counts as none if it is tiny beside the whole mesh.
#include "formulas/fracture.hpp"

namespace rigor {

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    double all = 0;
    for (const double V : volumes)
        all += V;
    std::vector<Matrix3d> smooth = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        Matrix3d sum = volumes[e] * stresses[e];
        double V = volumes[e];
        for (const int m : neighbours[e]) {
            sum += volumes[m] * stresses[m];
            V += volumes[m];
        }
        if (V > 1e-14 * all) smooth[e] = sum / V;
    }
    return smooth;
}

} // namespace rigor
