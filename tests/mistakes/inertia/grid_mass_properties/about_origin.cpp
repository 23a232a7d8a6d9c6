// SPDX-License-Identifier: MIT
// The inertia is about the origin; it must be about the center of mass.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    MassProperties result;
    for (const auto& [p, rho] : samples) {
        const double m = rho * cell_size * cell_size * cell_size;
        result.mass += m;
        result.center_of_mass += m * p;
        result.inertia += m * (p.squaredNorm() * Matrix3d::Identity() - p * p.transpose());
    }
    if (result.mass == 0) return {};
    result.center_of_mass /= result.mass;
    return result;
}

} // namespace rigor
