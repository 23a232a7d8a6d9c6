// SPDX-License-Identifier: MIT
// The index order is wrong: x varies fastest in the array of nodes, not z.
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
                    (i ? t.x() : 1 - t.x()) * (j ? t.y() : 1 - t.y()) * (k ? t.z() : 1 - t.z());
                phi += weight * grid.distances[z + grid.size[2] * (y + grid.size[1] * x)];
            }
    return phi + (s - nearest).norm() * grid.cell_size;
}

} // namespace rigor
