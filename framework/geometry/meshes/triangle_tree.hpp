// SPDX-License-Identifier: MIT
// The triangles of a mesh in a bounding tree, to find the nearest.
#pragma once

#include "geometry/bounds/bounding_tree.hpp"
#include "geometry/meshes/triangle.hpp"

namespace rigor {

/// Answers which point of a mesh is nearest to a point, and where the distance has local minima.
class TriangleTree {
public:
    /// @param mesh  must live longer than the tree
    explicit TriangleTree(const TriangleMesh& mesh);

    /// A nearest point with its triangle.
    struct Found : NearestOnTriangle {
        int triangle = 0;
        double squared_distance = 0; // [m²]
    };

    /// The point of the mesh nearest to p.
    /// @param near  a triangle from which the search starts; the nearer it is, the shorter the
    /// search
    Found nearest(const Vector3d& p, int near = 0) const;

    /// Local minima of the distance to p, those nearer than `within` [m], the nearest first: for
    /// each triangle its nearest point, unless that point also belongs to a triangle that comes
    /// nearer.
    std::vector<Found> local_minima(const Vector3d& p, double within) const;

    const BoundingTree& tree() const { return tree_; }

private:
    void descend(int index, const Vector3d& p, Found& best) const;
    bool is_on(const Found& found, int triangle) const;

    const TriangleMesh& mesh_;
    BoundingTree tree_;
};

} // namespace rigor
