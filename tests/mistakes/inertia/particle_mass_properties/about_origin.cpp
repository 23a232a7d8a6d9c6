// SPDX-License-Identifier: MIT
// The inertia is about the origin; it must be about the center of mass, with dᵢ = pᵢ - X.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    MassProperties result;
    for (const auto& [m, p] : particles) {
        result.mass += m;
        result.center_of_mass += m * p;
        result.inertia += m * (p.squaredNorm() * Matrix3d::Identity() - p * p.transpose());
    }
    if (result.mass == 0) return {};
    result.center_of_mass /= result.mass;
    return result;
}

} // namespace rigor
