// SPDX-License-Identifier: MIT
// The node below the point is found by adding the cell size again and again, and the rounding
// errors of these sums move the nodes of a long grid.
#include "formulas/collision.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace rigor {

namespace {

struct Place {
    int cell = 0;
    double fraction = 0; // within the cell, 0 … 1
};

/// The cell of a point at the distance x from the first node, which is held to the grid.
Place locate(double x, double h, int nodes)
{
    Place place;
    double node = 0;
    while (place.cell + 2 < nodes && node + h <= x) {
        node += h;
        ++place.cell;
    }
    place.fraction = (x - node) / h;
    return place;
}

} // namespace

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    const Vector3d from = p - grid.origin;
    Vector3d held;
    std::array<Place, 3> at;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto e = static_cast<Eigen::Index>(axis);
        held[e] = std::clamp(from[e], 0.0, grid.cell_size * (grid.size[axis] - 1));
        at[axis] = locate(held[e], grid.cell_size, grid.size[axis]);
    }

    const auto value = [&](int i, int j, int k) {
        return grid.distances[static_cast<std::size_t>(i + grid.size[0] * (j + grid.size[1] * k))];
    };
    const double a = at[0].fraction, b = at[1].fraction, c = at[2].fraction;
    double phi = 0;
    for (int s = 0; s < 2; ++s) {
        for (int r = 0; r < 2; ++r) {
            const double low = value(at[0].cell, at[1].cell + r, at[2].cell + s);
            const double high = value(at[0].cell + 1, at[1].cell + r, at[2].cell + s);
            phi += (s == 1 ? c : 1 - c) * (r == 1 ? b : 1 - b) * ((1 - a) * low + a * high);
        }
    }
    return phi + (from - held).norm();
}

} // namespace rigor
