// SPDX-License-Identifier: MIT
// Correct helper functions for the mistakes of A4.1 and A4.2: the grid cell of a point, and sums
// over the corners of the cell.
#pragma once

#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

/// The cell around a point and the coordinates of the point, in units of the cell size.
struct Cell {
    // s: the point; nearest: the nearest point of the grid; t: that one, from the lowest corner.
    Vector3d s, nearest, t;
    std::array<int, 3> lowest;
};

/// The cell of a point. A point outside of the grid gets the cell of the nearest point of the grid.
///
/// @param extrapolates  a point outside keeps its own coordinates, so that the border cell is
///                      extrapolated
/// @param takes_lower   a point on the face between two cells gets the lower one
inline Cell cell_of(const LevelSet& grid, const Vector3d& p, bool extrapolates = false,
                    bool takes_lower = false)
{
    Cell cell;
    cell.s = (p - grid.origin) / grid.cell_size;
    for (int i = 0; i < 3; ++i) {
        const double s = extrapolates ? cell.s[i] : std::clamp(cell.s[i], 0.0, grid.size[i] - 1.0);
        const double first = takes_lower ? std::ceil(s) - 1 : std::floor(s);
        cell.nearest[i] = s;
        cell.lowest[i] = static_cast<int>(std::clamp(first, 0.0, grid.size[i] - 2.0));
        cell.t[i] = s - cell.lowest[i];
    }
    return cell;
}

using Corner = std::array<int, 3>; // 0 or 1 along each axis

/// sum + Σ weight(corner) × distance, over the eight corners of the cell.
template <class Value, class Weight>
Value sum_over_corners(const LevelSet& grid, const Cell& cell, Value sum, const Weight& weight)
{
    for (int i = 0; i < 8; ++i) {
        const Corner corner = {i & 1, i >> 1 & 1, i >> 2};
        const int x = cell.lowest[0] + corner[0], y = cell.lowest[1] + corner[1],
                  z = cell.lowest[2] + corner[2];
        sum += weight(corner) * grid.distances[x + grid.size[0] * (y + grid.size[1] * z)];
    }
    return sum;
}

/// The trilinear interpolation of the distance in the cell [m].
inline double interpolated(const LevelSet& grid, const Cell& cell)
{
    return sum_over_corners(grid, cell, 0.0, [&](const Corner& corner) {
        double weight = 1;
        for (int a = 0; a < 3; ++a)
            weight *= corner[a] ? cell.t[a] : 1 - cell.t[a];
        return weight;
    });
}

/// The distance from the point to the grid, 0 inside [m].
inline double distance_to_box(const LevelSet& grid, const Cell& cell)
{
    return (cell.s - cell.nearest).norm() * grid.cell_size;
}

/// The gradient of the trilinear interpolation, times the cell size [m].
inline Vector3d gradient_in(const LevelSet& grid, const Cell& cell)
{
    return sum_over_corners(grid, cell, Vector3d(Vector3d::Zero()), [&](const Corner& corner) {
        Vector3d slopes; // derivatives of the corner's weight along each axis
        for (int a = 0; a < 3; ++a) {
            slopes[a] = corner[a] ? 1 : -1;
            for (int other : {(a + 1) % 3, (a + 2) % 3})
                slopes[a] *= corner[other] ? cell.t[other] : 1 - cell.t[other];
        }
        return slopes;
    });
}

inline Vector3d direction_of(const Vector3d& gradient)
{
    return gradient.norm() == 0 ? Vector3d(Vector3d::UnitY())
                                : Vector3d(gradient / gradient.norm());
}

} // namespace rigor
