// SPDX-License-Identifier: MIT
// A point less than 1e-10 of a cell below a face belongs to its own cell, not to the higher one.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    Cell cell = cell_of(grid, p);
    for (int i = 0; i < 3; ++i) {
        const double first = std::floor(cell.nearest[i] + 1e-10);
        cell.lowest[i] = std::min(static_cast<int>(first), grid.size[i] - 2);
        cell.t[i] = std::clamp(cell.nearest[i] - cell.lowest[i], 0.0, 1.0);
    }
    return direction_of(gradient_in(grid, cell));
}

} // namespace rigor
