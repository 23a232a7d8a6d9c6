// SPDX-License-Identifier: MIT
// A zero gradient has no direction, and dividing by its length gives NaN.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const Vector3d gradient = gradient_in(grid, cell_of(grid, p));
    return gradient / gradient.norm();
}

} // namespace rigor
