// SPDX-License-Identifier: MIT
// A point on the face between two cells belongs to the higher cell, not to the lower one.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const bool extrapolates = false, takes_lower = true;
    return direction_of(gradient_in(grid, cell_of(grid, p, extrapolates, takes_lower)));
}

} // namespace rigor
