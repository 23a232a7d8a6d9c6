// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/types.hpp"

#include <span>
#include <vector>

namespace rigor {

/// The corners of the convex hull of points in a plane. Points inside the hull or on its edges are
/// left out, also if they miss an edge by rounding; of points at one place, one is taken.
///
/// @param points  not empty; their distances along n do not matter
/// @param n       unit normal of the plane
/// @return their indices, ascending
std::vector<int> extreme_points(std::span<const Vector3d> points, const Vector3d& n);

} // namespace rigor
