// SPDX-License-Identifier: MIT
// A gradient times the cell size below 1e-9 m counts as zero, as on a grid of very small cells.
#include "formulas/collision.hpp"

#include <algorithm>

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    std::array<int, 3> cell;
    Vector3d t;
    for (int i = 0; i < 3; ++i) {
        const double s = (p[i] - grid.origin[i]) / grid.cell_size;
        const double nearest = std::clamp(s, 0.0, grid.size[i] - 1.0);
        cell[i] = std::min(static_cast<int>(nearest), grid.size[i] - 2);
        t[i] = nearest - cell[i];
    }
    Vector3d slope = Vector3d::Zero();
    for (int corner = 0; corner < 8; ++corner) {
        std::size_t index = 0;
        for (int i = 2; i >= 0; --i)
            index = index * static_cast<std::size_t>(grid.size[i]) + cell[i] + (corner >> i & 1);
        for (int axis = 0; axis < 3; ++axis) {
            double weight = 1;
            for (int i = 0; i < 3; ++i) {
                const bool up = corner >> i & 1;
                weight *= i == axis ? (up ? 1 : -1) : up ? t[i] : 1 - t[i];
            }
            slope[axis] += weight * grid.distances[index];
        }
    }
    if (slope.norm() < 1e-9) return Vector3d::UnitY();
    return slope.normalized();
}

} // namespace rigor
