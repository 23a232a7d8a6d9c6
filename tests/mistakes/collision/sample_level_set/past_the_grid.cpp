// SPDX-License-Identifier: MIT
// On the last face of the grid, nodes beyond the grid are read, with the weight 0.
#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    Vector3d nearest;
    int cell[3];
    Vector3d t;
    const Vector3d s = (p - grid.origin) / grid.cell_size;
    for (int i = 0; i < 3; ++i) {
        nearest[i] = std::clamp(s[i], 0.0, grid.size[i] - 1.0);
        cell[i] = static_cast<int>(nearest[i]);
        t[i] = nearest[i] - cell[i];
    }
    double phi = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        int at[3];
        for (int i = 0; i < 3; ++i) {
            const int upper = corner >> i & 1;
            at[i] = cell[i] + upper;
            weight *= upper ? t[i] : 1 - t[i];
        }
        const double* distances = grid.distances.data();
        phi += weight * distances[at[0] + grid.size[0] * (at[1] + grid.size[1] * at[2])];
    }
    return phi + grid.cell_size * (s - nearest).norm();
}

} // namespace rigor
