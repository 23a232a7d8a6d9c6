// SPDX-License-Identifier: MIT
// Points, segments and triangles.
#pragma once

#include "formulas/types.hpp"
#include "geometry/bounds/bounds.hpp"

namespace rigor {

struct Triangle {
    Vector3d a, b, c;

    Vector3d area_normal() const { return (b - a).cross(c - a) / 2; } // as long as the area [m²]
    Bounds bounds() const { return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)}; }
};

inline Triangle triangle_of(const TriangleMesh& mesh, int index)
{
    const auto& [i, j, k] = mesh.triangles[index];
    return {mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]};
}

/// The bounds of all vertices of a mesh.
Bounds bounds_of(const TriangleMesh& mesh);

/// The point of a triangle nearest to another point, and what it lies on: 0, 1, 2 the vertices a, b,
/// c; 3, 4, 5 the edges ab, bc, ca; 6 the face.
struct NearestOnTriangle {
    Vector3d point;
    int feature = 6;
};

/// By the regions of the triangle's plane (Ericson 2005, "Real-time collision detection", 5.1.5).
NearestOnTriangle nearest_on(const Triangle& triangle, const Vector3d& p);

/// Whether the segment from p to q goes through the triangle, from one side of its plane clearly to
/// the other.
///
/// @param tolerance  a volume within which p or q counts as in the plane [m³]
bool pierces(const Vector3d& p, const Vector3d& q, const Triangle& triangle, double tolerance);

} // namespace rigor
