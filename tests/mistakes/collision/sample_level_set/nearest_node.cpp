// SPDX-License-Identifier: MIT
// The value of the nearest node is returned; it must be interpolated between the nodes.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    const Cell cell = cell_of(grid, p);
    const auto is_nearest = [&](const Corner& corner) {
        for (int a = 0; a < 3; ++a)
            if (corner[a] != (cell.t[a] >= 0.5)) return 0.0;
        return 1.0;
    };
    return sum_over_corners(grid, cell, 0.0, is_nearest) + distance_to_box(grid, cell);
}

} // namespace rigor
