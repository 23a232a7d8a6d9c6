// SPDX-License-Identifier: MIT
// The gradient is taken at the cell's lowest node instead of at p.
#include "mistakes/collision/level_set.hpp"

namespace rigor {

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const Cell cell = cell_of(grid, p);
    const auto along_its_edge = [](const Corner& corner) {
        Vector3d slopes;
        for (int a = 0; a < 3; ++a) {
            const bool is_on_edge = !corner[(a + 1) % 3] && !corner[(a + 2) % 3];
            slopes[a] = !is_on_edge ? 0 : corner[a] ? 1 : -1;
        }
        return slopes;
    };
    return direction_of(sum_over_corners(grid, cell, Vector3d(Vector3d::Zero()), along_its_edge));
}

} // namespace rigor
