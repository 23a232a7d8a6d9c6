// SPDX-License-Identifier: MIT
// A point beyond an upper face is moved inwards along all axes, which may change its cell.
#include "mistakes/collision/level_set.hpp"

#include <algorithm>

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    bool is_beyond = false;
    Vector3d place = (p - grid.origin) / grid.cell_size;
    for (int axis = 0; axis < 3; ++axis) {
        is_beyond = is_beyond || place[axis] > grid.size[axis] - 1;
        place[axis] = std::clamp(place[axis], 0.0, grid.size[axis] - 1.0);
    }
    if (is_beyond) place *= 1 - 0x1p-52;
    return direction_of(gradient_in(grid, cell_of(grid, grid.origin + grid.cell_size * place)));
}

} // namespace rigor
