// SPDX-License-Identifier: MIT
// The interpolation weights are swapped: at t = 0 the lower node has weight 1.
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
