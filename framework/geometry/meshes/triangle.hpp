// SPDX-License-Identifier: MIT
// Triangles: normals, bounds, nearest points, and whether a segment goes through a triangle.
#pragma once

#include "formulas/types.hpp"
#include "geometry/bounds/bounds.hpp"

namespace rigor {

/// A triangle, given by its vertices, counter-clockwise seen from outside [m].
struct Triangle {
    Vector3d a, b, c;

    /// The outward normal, whose length is the area [m²].
    Vector3d area_normal() const { return (b - a).cross(c - a) / 2; }
    Bounds bounds() const { return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)}; }
};

inline Triangle triangle_of(const TriangleMesh& mesh, int index)
{
    const auto& [i, j, k] = mesh.triangles[index];
    return {mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]};
}

/// The bounds of all vertices of a mesh.
Bounds bounds_of(const TriangleMesh& mesh);

/// The point of a triangle nearest to another point, and the feature that it lies on. The features
/// 0, 1, 2 are the vertices a, b, c, the features 3, 4, 5 the edges ab, bc, ca, and 6 is the face.
struct NearestOnTriangle {
    Vector3d point;
    int feature = 6;
};

/// The point of the triangle nearest to p, by the Voronoi regions of the triangle's features
/// (Ericson 2005, "Real-time collision detection", 5.1.5).
NearestOnTriangle nearest_on(const Triangle& triangle, const Vector3d& p);

/// Whether the segment from p to q goes through the triangle. The result is false if an end lies in
/// the triangle's plane, up to the tolerance.
///
/// @param tolerance  p or q counts as in the plane if six times the volume of the tetrahedron that
///                   it forms with the triangle is at most this [m³]
bool pierces(const Vector3d& p, const Vector3d& q, const Triangle& triangle, double tolerance);

} // namespace rigor
