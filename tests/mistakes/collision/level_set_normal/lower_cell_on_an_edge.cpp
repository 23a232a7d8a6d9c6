// SPDX-License-Identifier: MIT
// On an edge along y the point belongs to the higher cell along x and z; here the lower along z.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    Cell cell = cell_of(grid, p);
    if (cell.t.x() == 0 && cell.t.z() == 0 && cell.lowest[2] > 0) {
        --cell.lowest[2];
        cell.t.z() = 1;
    }
    return direction_of(gradient_in(grid, cell));
}

} // namespace rigor
