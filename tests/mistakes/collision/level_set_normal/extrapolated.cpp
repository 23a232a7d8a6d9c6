// SPDX-License-Identifier: MIT
// Outside the grid the gradient is that at the nearest point of the grid; here it is extrapolated.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const bool extrapolates = true;
    return direction_of(gradient_in(grid, cell_of(grid, p, extrapolates)));
}

} // namespace rigor
