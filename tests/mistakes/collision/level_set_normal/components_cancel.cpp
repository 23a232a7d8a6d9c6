// SPDX-License-Identifier: MIT
// A gradient counts as zero if its components add up to zero.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const Vector3d gradient = gradient_in(grid, cell_of(grid, p));
    if (gradient.sum() == 0) return Vector3d::UnitY();
    return gradient / gradient.norm();
}

} // namespace rigor
