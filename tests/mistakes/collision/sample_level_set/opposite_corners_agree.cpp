// SPDX-License-Identifier: MIT
// A cell is taken for constant if each two opposite corners have equal distances.
#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    double place[3];
    int cell[3];
    double outside = 0;
    for (int k = 0; k < 3; ++k) {
        const double last = grid.size[k] - 1;
        const double end = grid.origin[k] + grid.cell_size * last;
        const double q = std::clamp(p[k], grid.origin[k], end);
        outside = std::hypot(outside, p[k] - q);
        const double t = std::clamp((q - grid.origin[k]) / grid.cell_size, 0.0, last);
        cell[k] = std::min(static_cast<int>(t), grid.size[k] - 2);
        place[k] = t - cell[k];
    }
    double value[8];
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1, j = (corner >> 1) & 1, k = corner >> 2;
        const int node = cell[0] + i + grid.size[0] * (cell[1] + j + grid.size[1] * (cell[2] + k));
        value[corner] = grid.distances[node];
    }
    bool constant = true;
    for (int corner = 0; corner < 4; ++corner)
        constant = constant && value[corner] == value[7 - corner];
    if (constant) return value[0] + outside;
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1, j = (corner >> 1) & 1, k = corner >> 2;
        sum += (i ? place[0] : 1 - place[0]) * (j ? place[1] : 1 - place[1]) *
               (k ? place[2] : 1 - place[2]) * value[corner];
    }
    return sum + outside;
}

} // namespace rigor
