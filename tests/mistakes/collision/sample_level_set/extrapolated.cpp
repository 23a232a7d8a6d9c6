// SPDX-License-Identifier: MIT
// Outside the grid the border cell is extrapolated; the distance to the grid must be added instead.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    const bool extrapolates = true;
    return interpolated(grid, cell_of(grid, p, extrapolates));
}

} // namespace rigor
