// SPDX-License-Identifier: MIT
// A4.1 and A4.2: points just beside the faces between the cells of a level set, and just inside and
// outside of its border. All numbers are dyadic, so that the cell of each point is known exactly.
#include "formulas/collision.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <array>
#include <cmath>

namespace collision_faces_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// φ = f(x) + g(y) + h(z), where f, g and h have another slope in each cell. Slopes and values at
// the nodes are small multiples of a power of two.
struct Folded {
    LevelSet grid;
    std::array<std::vector<double>, 3> slopes;

    explicit Folded(Random& random)
    {
        grid.cell_size = std::ldexp(1, random_index(random, 5) - 2);
        grid.size = {5, 4, 3};
        std::array<std::vector<double>, 3> values;
        for (int axis = 0; axis < 3; ++axis) {
            grid.origin[axis] = grid.cell_size * (random_index(random, 5) - 2);
            values[axis] = {0};
            for (int cell = 0; cell + 1 < grid.size[axis]; ++cell) {
                slopes[axis].push_back((1 + cell + random_index(random, 8) * 4) / 8.0);
                values[axis].push_back(values[axis].back() + grid.cell_size * slopes[axis].back());
            }
        }
        for (int k = 0; k < grid.size[2]; ++k)
            for (int j = 0; j < grid.size[1]; ++j)
                for (int i = 0; i < grid.size[0]; ++i)
                    grid.distances.push_back(values[0][i] + values[1][j] + values[2][k]);
    }
    Vector3d node(const std::array<int, 3>& place) const
    {
        return grid.origin + grid.cell_size * Vector3d(place[0], place[1], place[2]);
    }
    // the slope along an axis at a point less than a cell away from node `place`: below the node
    // (side = -1), at it (0) or above it (1)
    double slope(int axis, int place, int side) const
    {
        const int last = grid.size[axis] - 2, cell = side < 0 ? place - 1 : place;
        return slopes[axis][std::min(std::max(cell, 0), last)];
    }
};

// Along each axis, the side of a node on which a point is: below (-1), at the node (0), above (1).
std::array<int, 3> sides_of(int number)
{
    return {number % 3 - 1, number / 3 % 3 - 1, number / 9 - 1};
}

} // namespace

TEST_CASE("collision: just beside a face the normal is that of the point's own cell",
          "[A4.2][collision]")
{
    for (Random random : seeds(3)) {
        const Folded phi(random);
        for (int power = 1; power <= 48; ++power) {
            const double beside = std::ldexp(phi.grid.cell_size, -power);
            for (int number = 0; number < 27; ++number) {
                const std::array<int, 3> sides = sides_of(number);
                std::array<int, 3> place = {0, 0, 0};
                Vector3d p, gradient;
                for (int axis = 0; axis < 3; ++axis) {
                    place[axis] =
                        random_index(random, static_cast<std::size_t>(phi.grid.size[axis]));
                    p[axis] = phi.node(place)[axis] + sides[axis] * beside;
                    gradient[axis] = phi.slope(axis, place[axis], sides[axis]);
                }
                CAPTURE(p, beside);
                // the values are at most 64 times the cell size, and the slopes at least 1/8
                REQUIRE_THAT(level_set_normal(phi.grid, p),
                             IsClose(gradient.normalized(), Rounding(64, 64)));
            }
        }
    }
}

TEST_CASE("collision: just beside a node the distance changes by the slope of the cell",
          "[A4.1][collision]")
{
    for (Random random : seeds(3)) {
        const Folded phi(random);
        for (int power = 1; power <= 40; ++power) {
            const double beside = std::ldexp(phi.grid.cell_size, -power);
            for (int number = 0; number < 27; ++number) {
                const std::array<int, 3> sides = sides_of(number);
                const std::array<int, 3> place = {random_index(random, 5), random_index(random, 4),
                                                  random_index(random, 3)};
                const Vector3d node = phi.node(place);
                Vector3d p = node;
                double expected = phi.grid.distances[place[0] + 5 * (place[1] + 4 * place[2])];
                double outside = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    const int at = place[axis] + sides[axis];
                    p[axis] += sides[axis] * beside;
                    if (at < 0 || at == phi.grid.size[axis])
                        outside += beside * beside;
                    else
                        expected +=
                            sides[axis] * beside * phi.slope(axis, place[axis], sides[axis]);
                }
                CAPTURE(p, beside);
                const double size = 64 * phi.grid.cell_size; // the magnitude of the values
                REQUIRE_THAT(sample_level_set(phi.grid, p),
                             IsClose(expected + std::sqrt(outside), Rounding(16, size)));
            }
        }
    }
}

} // namespace collision_faces_test
