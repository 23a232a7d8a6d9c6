// SPDX-License-Identifier: MIT
// A4.1 and A4.2: grids with very many nodes along one axis.
#include "formulas/collision.hpp"
#include "support/close.hpp"

#include <array>

namespace rigor::testing::collision_long_grids_test {

namespace {

// A grid that is long along one axis. Its values there are 0 at even indices and 0.1 at odd ones.
constexpr int long_size = 200'001;

LevelSet zigzag(int axis)
{
    LevelSet grid{{1, -2, 3}, 0.1, {2, 2, 2}, {}};
    grid.size[axis] = long_size;
    for (int k = 0; k < grid.size[2]; ++k)
        for (int j = 0; j < grid.size[1]; ++j)
            for (int i = 0; i < grid.size[0]; ++i)
                grid.distances.push_back(0.1 * (std::array{i, j, k}[axis] % 2));
    return grid;
}

// The point of cell i of that grid, at this fraction of its edge.
Vector3d point_of_cell(const LevelSet& grid, int axis, int i, double fraction)
{
    Vector3d p = grid.origin + Vector3d(0.03, 0.05, 0.08);
    p[axis] = grid.origin[axis] + grid.cell_size * (i + fraction);
    return p;
}
constexpr int far_cells[] = {0, 1, 255, 256, 40'000, 65'535, 65'536, 131'071, 199'998, 199'999};

} // namespace

TEST_CASE("collision: a grid may have any number of cells", "[A4.1][collision]")
{
    for (const int axis : {0, 1, 2}) {
        const LevelSet grid = zigzag(axis);
        for (const int i : far_cells)
            for (const double fraction : {0.001, 0.75}) {
                CAPTURE(axis, i, fraction);
                const double expected = 0.1 * (i % 2 == 0 ? fraction : 1 - fraction);
                const Vector3d p = point_of_cell(grid, axis, i, fraction);
                // the rounding of p, since the slope is 1
                REQUIRE_THAT(sample_level_set(grid, p),
                             IsClose(expected, Rounding(32, 10 + p.norm())));
            }
    }
}

TEST_CASE("collision: a grid of any number of cells has normals", "[A4.2][collision]")
{
    for (const int axis : {0, 1, 2}) {
        const LevelSet grid = zigzag(axis);
        for (const int i : far_cells)
            for (const double fraction : {1e-6, 1 - 1e-6}) {
                CAPTURE(axis, i, fraction);
                const Vector3d expected = (i % 2 == 0 ? 1 : -1) * Vector3d::Unit(axis);
                REQUIRE_THAT(level_set_normal(grid, point_of_cell(grid, axis, i, fraction)),
                             IsClose(expected, Rounding(16, 1)));
            }
    }
}

} // namespace rigor::testing::collision_long_grids_test
