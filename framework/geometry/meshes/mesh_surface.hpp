// SPDX-License-Identifier: MIT
// The surface of a mesh as points and edges that other bodies can meet.
#pragma once

#include "geometry/bounds/bounding_tree.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// A point of a surface, on a vertex, an edge or a face.
struct SurfacePoint {
    Vector3d point;
    int cone = 0; // of its outward normals
};

/// An edge that sticks out.
struct SharpEdge {
    Vector3d from, to;
    Vector3d normal1, normal2; // unit, of its faces
    int cone = 0;
};

/// Points about a spacing apart on faces and along edges that bend outwards, and the edges that do so
/// by more than ten degrees, in trees. Edges and faces that the surface bends away from are left out:
/// what sticks out elsewhere gets there first.
class MeshSurface {
public:
    /// @param spacing  > 0 [m]
    MeshSurface(const TriangleMesh& mesh, double spacing);

    /// Those on vertices first, then those on edges.
    const std::vector<SurfacePoint>& points() const { return points_; }
    const std::vector<SharpEdge>& edges() const { return edges_; }
    double spacing() const { return spacing_; }
    const BoundingTree& point_tree() const { return point_tree_; }
    const BoundingTree& edge_tree() const { return edge_tree_; }

    /// The unit direction nearest to the unit vector d that the surface can be touched along from outside
    /// at a point of this cone: one normal on a face, those between two on an edge, those between
    /// several at a vertex. At a saddle, where no plane leaves the surface on one side, d itself.
    Vector3d nearest_normal(int cone, const Vector3d& d) const;

private:
    // Normals of the faces around a point, and directions along the surface away from it: a plane that
    // all directions stay below touches the surface.
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
