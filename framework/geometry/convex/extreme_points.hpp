// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/types.hpp"

#include <span>
#include <vector>

namespace rigor {

/// The corners of the convex hull of points in a plane. Points inside the hull or on its edges, up
/// to rounding, are left out. If several points are at the same place, one of them is taken.
///
/// @param points  not empty; their components along n are ignored
/// @param n       unit normal of the plane
/// @return their indices, ascending
std::vector<int> extreme_points(std::span<const Vector3d> points, const Vector3d& n);

} // namespace rigor
