// SPDX-License-Identifier: MIT
// The surface of a mesh as sample points and sharp edges, for contacts with other bodies.
#pragma once

#include "geometry/bounds/bounding_tree.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// A sample point of a surface, on a vertex, an edge or a face [m].
struct SurfacePoint {
    Vector3d point;
    int cone = 0; // index of its normal cone, for `MeshSurface::nearest_normal`
};

/// A sharp convex edge.
struct SharpEdge {
    Vector3d from, to;         // ends [m]
    Vector3d normal1, normal2; // unit normals of the two faces
    int cone = 0;              // index of its normal cone, for `MeshSurface::nearest_normal`
};

/// The sample points and the sharp edges of a surface. Points lie on all vertices, along convex
/// edges at most one spacing apart, and in rows on faces at most two spacings apart. A short edge
/// or a small face has a point in its middle if its vertices cannot be touched, as in a round hole.
/// Sharp edges are convex edges at which the normals of the faces differ by more than about ten
/// degrees. Points and edges have a bounding tree each. Concave edges have no points along them,
/// because another body always touches another part of the surface first.
class MeshSurface {
public:
    /// @param spacing  largest distance of neighboring points on an edge, > 0 [m]
    MeshSurface(const TriangleMesh& mesh, double spacing);

    /// The points on vertices first, then those on edges, then those on faces.
    const std::vector<SurfacePoint>& points() const { return points_; }
    const std::vector<SharpEdge>& edges() const { return edges_; }
    double spacing() const { return spacing_; }
    const BoundingTree& point_tree() const { return point_tree_; }
    const BoundingTree& edge_tree() const { return edge_tree_; }

    /// The unit vector nearest to the unit vector d among those of a normal cone. The cone contains
    /// the directions from which another body can touch the surface: on a face only its normal, on
    /// an edge all directions between its two normals, at a vertex all directions between the
    /// normals of the faces around it. A saddle has no tangent plane that stays on one side of the
    /// surface; there the result is d.
    /// @param cone  index of the cone, from a SurfacePoint or SharpEdge
    Vector3d nearest_normal(int cone, const Vector3d& d) const;

private:
    // A normal cone: the normals of the faces around a point, as a range of `cone_normals_`, and
    // the directions along the surface away from the point, as a range of `cone_directions_`. The
    // cone contains the vectors that make no acute angle with any of the directions.
    struct Cone {
        int first_normal = 0, last_normal = 0, first_direction = 0, last_direction = 0;
    };
    int add_cone(const std::vector<Vector3d>& normals, const std::vector<Vector3d>& directions);
    bool touches(const Cone& cone, const Vector3d& d) const;
    void add_vertices(const TriangleMesh& mesh, const std::vector<Vector3d>& normals);
    void add_edges(const TriangleMesh& mesh, const std::vector<Vector3d>& normals);
    void add_faces(const TriangleMesh& mesh, const std::vector<Vector3d>& normals);

    double spacing_;
    std::vector<SurfacePoint> points_;
    std::vector<SharpEdge> edges_;
    std::vector<Cone> cones_;
    std::vector<Vector3d> cone_normals_, cone_directions_;
    BoundingTree point_tree_, edge_tree_;
};

} // namespace rigor
