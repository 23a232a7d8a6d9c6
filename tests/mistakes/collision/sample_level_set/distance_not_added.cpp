// SPDX-License-Identifier: MIT
// Outside the grid the distance to the grid must be added to the value on its border.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    return interpolated(grid, cell_of(grid, p));
}

} // namespace rigor
