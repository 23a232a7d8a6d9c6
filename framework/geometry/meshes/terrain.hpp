// SPDX-License-Identifier: MIT
// The solid below an open surface.
#pragma once

#include "formulas/types.hpp"

#include <vector>

namespace rigor {

/// The solid between an open surface, such as a terrain, and a flat bottom below it: the surface
/// itself, the bottom, and upright walls along the border.
///
/// @param surface  a mesh whose faces are all counter-clockwise seen from above, from +y
/// @param depth    from the lowest point of the surface down to the bottom, > 0 [m]
/// @param lines    for each triangle, its line in the text of the mesh, which the error names;
///                 empty if the mesh has no text
/// @return         a mesh that encloses a solid, if no face of the surface is above another
/// @throws MeshError
TriangleMesh solid_below(const TriangleMesh& surface, double depth,
                         const std::vector<int>& lines = {});

} // namespace rigor
