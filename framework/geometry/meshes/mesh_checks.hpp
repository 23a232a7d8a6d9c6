// SPDX-License-Identifier: MIT
// What a triangle mesh must be to have an inside.
#pragma once

#include "formulas/types.hpp"
#include "geometry/meshes/mesh_error.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

inline constexpr std::size_t most_mesh_triangles = 200'000, most_mesh_vertices = 200'000;

/// Signed volume that the triangles enclose, positive if they turn counter-clockwise seen from
/// outside [m³].
double signed_volume(const TriangleMesh& mesh);

/// Refuses what is not the surface of a solid: no triangle at all, too many, a vertex that is not a
/// number or does not exist, a face without area, an edge that does not have exactly two faces which
/// run through it in opposite directions, faces that look inwards, a surface that goes through
/// itself, a piece within another one that is no hollow.
///
/// @param lines  of each triangle in its text, to name in the error; empty: none
/// @throws MeshError
void check_mesh(const TriangleMesh& mesh, const std::vector<int>& lines = {});

} // namespace rigor
