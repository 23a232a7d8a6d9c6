// SPDX-License-Identifier: MIT
// Four or more cells of one density in a row along x are added as one piece, gaps or not.
#include "formulas/inertia.hpp"

#include <cstddef>

namespace rigor {

MassProperties grid_mass_properties(const std::vector<DensitySample>& samples, double cell_size)
{
    const double cell = cell_size * cell_size * cell_size;
    double mass = 0;
    Vector3d first = Vector3d::Zero();
    Matrix3d second = Matrix3d::Zero();
    std::size_t begin = 0;
    while (begin < samples.size()) {
        const DensitySample& start = samples[begin];
        std::size_t end = begin + 1;
        while (end < samples.size() && samples[end].density == start.density &&
               samples[end].position.y() == start.position.y() &&
               samples[end].position.z() == start.position.z() &&
               samples[end].position.x() > samples[end - 1].position.x()) {
            ++end;
        }
        const double m = start.density * cell;
        if (end - begin >= 4) {
            const double count = static_cast<double>(end - begin);
            const Vector3d middle = 0.5 * (start.position + samples[end - 1].position);
            mass += count * m;
            first += count * m * middle;
            second += count * m * (middle * middle.transpose());
            second(0, 0) += m * cell_size * cell_size * count * (count * count - 1) / 12;
        } else {
            for (std::size_t i = begin; i < end; ++i) {
                const Vector3d& x = samples[i].position;
                mass += m;
                first += m * x;
                second += m * (x * x.transpose());
            }
        }
        begin = end;
    }
    MassProperties result;
    if (mass == 0) {
        return result;
    }
    result.mass = mass;
    result.center_of_mass = first / mass;
    const Matrix3d C = second - mass * (result.center_of_mass * result.center_of_mass.transpose());
    result.inertia = C.trace() * Matrix3d::Identity() - C;
    return result;
}

} // namespace rigor
