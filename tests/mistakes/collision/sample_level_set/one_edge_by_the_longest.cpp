// SPDX-License-Identifier: MIT
// Beyond the edge at the highest x and lowest z, the larger distance is added, not the length.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    const Cell cell = cell_of(grid, p);
    const Vector3d beyond = (cell.s - cell.nearest) * grid.cell_size;
    const bool is_beyond_edge = beyond.x() > 0 && beyond.y() == 0 && beyond.z() < 0;
    return interpolated(grid, cell) +
           (is_beyond_edge ? beyond.lpNorm<Eigen::Infinity>() : beyond.norm());
}

} // namespace rigor
