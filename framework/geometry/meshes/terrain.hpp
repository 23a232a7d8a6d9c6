// SPDX-License-Identifier: MIT
// The solid below an open surface.
#pragma once

#include "formulas/types.hpp"

#include <vector>

namespace rigor {

/// The solid between an open surface, such as a terrain, and a flat bottom below it: the surface
/// itself, the bottom, and upright walls along the border.
///
/// @param surface  faces counter-clockwise seen from above, from +y; each is visible from there
/// @param depth    from the lowest point of the surface down to the bottom, > 0 [m]
/// @param lines    line of the text for each triangle, for the error; empty if there is no text
/// @return         closed, if no two faces of the surface are above each other
/// @throws MeshError
TriangleMesh solid_below(const TriangleMesh& surface, double depth,
                         const std::vector<int>& lines = {});

} // namespace rigor
