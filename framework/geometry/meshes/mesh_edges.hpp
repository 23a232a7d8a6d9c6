// SPDX-License-Identifier: MIT
// The edges of a triangle mesh.
#pragma once

#include "formulas/types.hpp"

#include <vector>

namespace rigor {

/// A half-edge: an edge as a side of one triangle.
struct HalfEdge {
    int low = 0, high = 0; // its vertices, low < high
    bool is_upward = true; // whether `low` is followed by `high` in the order of the triangle
    int triangle = 0;

    bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// The three half-edges of every triangle, sorted so that the half-edges of one edge are neighbors
/// in the list. In a closed mesh each edge has exactly two.
std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh);

/// An edge of a closed mesh, with the triangles on both sides.
struct MeshEdge {
    int from = 0, to = 0;    // vertices
    int left = 0, right = 0; // triangles; in the order of the left one, `to` follows `from`
    double bend = 0;         // sine of the angle between the normals, > 0 at a convex edge
};

/// All edges of a closed mesh.
/// @param normals  unit normals, one for each triangle
std::vector<MeshEdge> mesh_edges(const TriangleMesh& mesh, const std::vector<Vector3d>& normals);

/// The largest angle between the normals of two facets that share an edge, in a closed mesh that
/// approximates a round surface [rad]. Only convex edges with an angle below 0.7 rad (40 degrees)
/// count, because a larger angle is a real edge of the body. The result is 0 if there are none.
double facet_angle(const TriangleMesh& mesh);

/// Unit normal of each triangle.
std::vector<Vector3d> triangle_normals(const TriangleMesh& mesh);

} // namespace rigor
