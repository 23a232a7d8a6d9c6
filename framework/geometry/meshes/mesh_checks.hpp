// SPDX-License-Identifier: MIT
// The conditions under which a triangle mesh encloses a solid.
#pragma once

#include "formulas/types.hpp"
#include "geometry/meshes/mesh_error.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

/// Larger coordinates are refused: the limit guards volumes and their products against overflow
/// [m].
inline constexpr double largest_coordinate = 1e12;

/// Larger meshes are refused: the limits guard time and memory.
inline constexpr std::size_t most_mesh_triangles = 200'000, most_mesh_vertices = 200'000;

/// Signed volume that the triangles enclose, positive if they turn counter-clockwise seen from
/// outside [m³].
double signed_volume(const TriangleMesh& mesh);

/// Refuses a mesh that is not the surface of a solid. It must have triangles, and not too many.
/// Vertices must exist and be finite, and each face must have an area. Each edge must have two
/// faces, which pass it in opposite directions. Faces must turn counter-clockwise seen from
/// outside, and the surface must not intersect itself. A piece inside another piece must be a
/// hollow.
///
/// @param lines  line of the text for each triangle, for the error; empty if there is no text
/// @throws MeshError
void check_mesh(const TriangleMesh& mesh, const std::vector<int>& lines = {});

} // namespace rigor
