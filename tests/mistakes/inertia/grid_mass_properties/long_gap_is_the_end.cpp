// SPDX-License-Identifier: MIT
// More than 4096 empty cells behind the first solid one are taken for the end of the body.
#include "formulas/inertia.hpp"

#include <cstddef>

namespace rigor {

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    const double volume = cell_size * cell_size * cell_size;
    MassProperties body;
    double mass = 0;
    Vector3d moment = Vector3d::Zero();
    std::size_t end = 0, gap = 0;
    for (; end < samples.size(); ++end) {
        const double m = samples[end].density * volume;
        gap = m == 0 && mass != 0 ? gap + 1 : 0;
        if (gap > 4096) break;
        mass += m;
        moment += m * samples[end].position;
    }
    if (mass == 0) return body;
    body.mass = mass;
    body.center_of_mass = moment / mass;
    for (std::size_t i = 0; i < end; ++i) {
        const Vector3d d = samples[i].position - body.center_of_mass;
        body.inertia += samples[i].density * volume *
                        (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    return body;
}

} // namespace rigor
