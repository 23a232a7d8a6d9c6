// SPDX-License-Identifier: MIT
// A zero gradient has no direction: 0/0 is not a number.
#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const Vector3d s = (p - grid.origin) / grid.cell_size;
    Vector3d nearest, t;
    std::array<int, 3> cell;
    for (int i = 0; i < 3; ++i) {
        nearest[i] = std::clamp(s[i], 0.0, grid.size[i] - 1.0);
        cell[i] = static_cast<int>(std::clamp(std::floor(nearest[i]), 0.0, grid.size[i] - 2.0));
        t[i] = nearest[i] - cell[i];
    }
    Vector3d gradient = Vector3d::Zero();
    for (int corner = 0; corner < 8; ++corner) {
        const std::array<int, 3> end = {corner & 1, corner >> 1 & 1, corner >> 2};
        const int x = cell[0] + end[0], y = cell[1] + end[1], z = cell[2] + end[2];
        Vector3d w; // slope of the corner's weight along each axis
        for (int a = 0; a < 3; ++a) {
            w[a] = end[a] ? 1 : -1;
            for (int b = 1; b < 3; ++b) {
                const int c = (a + b) % 3;
                w[a] *= end[c] ? t[c] : 1 - t[c];
            }
        }
        gradient += w * grid.distances[x + grid.size[0] * (y + grid.size[1] * z)];
    }
    return gradient / gradient.norm();
}

} // namespace rigor
