// SPDX-License-Identifier: MIT
// A convex mesh as a polyhedron: vertices, neighbors and flat faces.
#pragma once

#include "formulas/types.hpp"
#include "geometry/convex/feature.hpp"

#include <array>
#include <vector>

namespace rigor {

/// A convex mesh as a solid. Its triangles are merged into flat faces, so every triangulation of a
/// solid gives the same faces, edges and corners.
class Hull {
public:
    // Contacts of meshes with more vertices use the level set instead, because `is_hull` would take
    // too long for them: it compares every vertex with every triangle.
    static constexpr std::size_t most_vertices = 1000;

    /// @param mesh  convex (`is_hull`)
    explicit Hull(const TriangleMesh& mesh);

    /// The farthest vertex along a direction.
    Vector3d support(const Vector3d& direction) const;

    /// The face, edge or vertex that faces a direction (`feature_towards` in distance/support.hpp).
    /// For a face with more than 16 vertices, the result has 16 of them.
    Feature feature_towards(const Vector3d& direction) const;

    /// Unit outward normals of the largest faces, at most 32.
    const std::vector<Vector3d>& face_normals() const { return face_normals_; }

private:
    struct Face {
        Vector3d normal;
        double area = 0;
        // Indices of vertices, counter-clockwise around the normal. Vertices that are no corner of
        // the solid, because they lie inside a face or along an edge, are left out.
        std::vector<int> corners;
    };
    int farthest(const Vector3d& direction) const;
    void merge_faces(const TriangleMesh& mesh);
    std::vector<int> outline(const Face& face, double tolerance) const;
    void find_corners(double tolerance);
    void link_neighbours();

    std::vector<Vector3d> vertices_;
    std::vector<Face> faces_;
    std::vector<Vector3d> face_normals_;
    std::vector<std::vector<int>> neighbours_; // for each vertex: the other ends of its edges
    // The vertices farthest along -x, +x, -y, …, at which searches start.
    std::array<int, 6> extremes_ = {};
};

/// Whether a closed mesh is convex (no vertex is above the plane of any face by more than 1e-9
/// times the longest side of the mesh's bounds) and has at most `Hull::most_vertices` vertices.
bool is_hull(const TriangleMesh& mesh);

} // namespace rigor
