// SPDX-License-Identifier: MIT
// The conditions under which a triangle mesh encloses a solid.
#pragma once

#include "formulas/types.hpp"
#include "geometry/meshes/mesh_error.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

/// Coordinates in mesh files with an absolute value above this limit [m] are refused, so that
/// volumes and products of volumes do not overflow.
inline constexpr double largest_coordinate = 1e12;

/// Larger meshes are refused: the limits bound run time and memory.
inline constexpr std::size_t most_mesh_triangles = 200'000, most_mesh_vertices = 200'000;

/// Signed volume that the triangles enclose, positive if triangles are counter-clockwise seen from
/// outside [m³].
double signed_volume(const TriangleMesh& mesh);

/// Refuses a mesh that is not the surface of a solid. It must have triangles, and not too many. The
/// vertices of faces must exist and be finite, and each face must have an area. Each edge must have
/// two faces, which traverse the edge in opposite directions. The surface must enclose a volume,
/// faces must be counter-clockwise seen from outside, and the surface must not intersect itself. A
/// closed piece of surface inside another piece must be the wall of a hollow. At most 64 pieces are
/// allowed.
///
/// @param lines  for each triangle, its line in the text of the mesh, which the error names; empty
///               if the mesh has no text
/// @throws MeshError
void check_mesh(const TriangleMesh& mesh, const std::vector<int>& lines = {});

} // namespace rigor
