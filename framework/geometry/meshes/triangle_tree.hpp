// SPDX-License-Identifier: MIT
// The triangles of a mesh in a bounding tree, to find the nearest one.
#pragma once

#include "geometry/bounds/bounding_tree.hpp"
#include "geometry/meshes/triangle.hpp"

namespace rigor {

/// Finds the point of a mesh that is nearest to a given point, and the local minima of the
/// distance.
class TriangleTree {
public:
    /// @param mesh  must live longer than the tree, which keeps only a reference to the mesh
    explicit TriangleTree(const TriangleMesh& mesh);

    /// The nearest point of one triangle, and the index of the triangle.
    struct Found : NearestOnTriangle {
        int triangle = 0;
        double squared_distance = 0; // [m²]
    };

    /// The point of the mesh nearest to p.
    /// @param near  index of the triangle with which the search starts; if this triangle is near p,
    ///              the search is shorter
    Found nearest(const Vector3d& p, int near = 0) const;

    /// The local minima of the distance to p that are below `within` [m], each once, the nearest
    /// first. Each triangle contributes its point nearest to p, unless this point lies on a vertex
    /// or edge of another triangle that has a point nearer to p. A point that several triangles
    /// contribute counts once.
    std::vector<Found> local_minima(const Vector3d& p, double within) const;

    const BoundingTree& tree() const { return tree_; }

private:
    void descend(int index, const Vector3d& p, Found& best) const;

    const TriangleMesh& mesh_;
    BoundingTree tree_;
};

} // namespace rigor
