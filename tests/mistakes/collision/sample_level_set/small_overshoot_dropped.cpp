// SPDX-License-Identifier: MIT
// Beyond the grid, the distance along an axis counts only above 1e-3 of the largest one.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    const Cell cell = cell_of(grid, p);
    Vector3d beyond = (cell.s - cell.nearest) * grid.cell_size;
    const double largest = beyond.lpNorm<Eigen::Infinity>();
    for (double& part : beyond)
        if (std::abs(part) < 1e-3 * largest) part = 0;
    return interpolated(grid, cell) + beyond.norm();
}

} // namespace rigor
