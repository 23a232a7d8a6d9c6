// SPDX-License-Identifier: MIT
// How the triangles of a mesh hang together.
#pragma once

#include "formulas/types.hpp"

#include <vector>

namespace rigor {

/// An edge as one triangle runs through it.
struct HalfEdge {
    int low = 0, high = 0; // its vertices
    bool is_upward = true; // from low to high
    int triangle = 0;

    bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// Three of each triangle, those of one edge together. In a closed mesh: pairs.
std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh);

/// An edge of a closed mesh.
struct MeshEdge {
    int from = 0, to = 0;    // vertices
    int left = 0, right = 0; // triangles; the left one runs from `from` to `to`
    double bend = 0;         // sine of the angle between the normals, > 0 where it is convex
};

std::vector<MeshEdge> mesh_edges(const TriangleMesh& mesh, const std::vector<Vector3d>& normals);

/// Unit normal of each triangle.
std::vector<Vector3d> triangle_normals(const TriangleMesh& mesh);

} // namespace rigor
