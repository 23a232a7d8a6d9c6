// SPDX-License-Identifier: MIT
// The distance grows outward, so the normal is along the gradient, not against it.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const Vector3d gradient = gradient_in(grid, cell_of(grid, p));
    if (gradient.norm() == 0) return Vector3d::UnitY();
    return -gradient / gradient.norm();
}

} // namespace rigor
