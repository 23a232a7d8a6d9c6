// SPDX-License-Identifier: MIT
// A gradient that is small beside the distances themselves counts as zero, but it has a direction.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const Vector3d gradient = gradient_in(grid, cell_of(grid, p));
    double farthest = 0;
    for (const double distance : grid.distances)
        farthest = std::max(farthest, std::abs(distance));
    if (gradient.norm() <= 1e-13 * farthest) return Vector3d::UnitY();
    return gradient / gradient.norm();
}

} // namespace rigor
