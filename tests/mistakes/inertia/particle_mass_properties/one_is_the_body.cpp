// SPDX-License-Identifier: MIT
// A particle with nearly all of the mass counts as the whole body, a point.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties particle_mass_properties(const std::vector<Particle>& particles)
{
    MassProperties result;
    for (const auto& [m, p] : particles) {
        result.mass += m;
        result.center_of_mass += m * p;
    }
    if (result.mass == 0) return {};
    result.center_of_mass /= result.mass;
    for (const auto& [m, p] : particles)
        if (m > 0.999999 * result.mass) return {result.mass, p, Matrix3d::Zero()};
    for (const auto& [m, p] : particles) {
        const Vector3d d = p - result.center_of_mass;
        result.inertia += m * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    return result;
}

} // namespace rigor
