// SPDX-License-Identifier: MIT
// The gradient itself is returned; the normal must have length 1.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const Vector3d gradient = gradient_in(grid, cell_of(grid, p));
    if (gradient.norm() == 0) return Vector3d::UnitY();
    return gradient / grid.cell_size;
}

} // namespace rigor
