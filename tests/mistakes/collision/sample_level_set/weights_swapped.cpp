// SPDX-License-Identifier: MIT
// The weights are swapped: at t = 0 the cell's lower node counts fully.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    Cell cell = cell_of(grid, p);
    const double outside = distance_to_box(grid, cell);
    cell.t = Vector3d::Ones() - cell.t;
    return interpolated(grid, cell) + outside;
}

} // namespace rigor
