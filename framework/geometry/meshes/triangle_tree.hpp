// SPDX-License-Identifier: MIT
// The triangles of a mesh in a tree: which is nearest, and which are near.
#pragma once

#include "geometry/bounds/bounding_tree.hpp"
#include "geometry/meshes/triangle.hpp"

namespace rigor {

class TriangleTree {
public:
    /// @param mesh  outlives this
    explicit TriangleTree(const TriangleMesh& mesh);

    struct Found : NearestOnTriangle {
        int triangle = 0;
        double squared_distance = 0; // [m²]
    };

    /// The point of the mesh nearest to p.
    /// @param near  a triangle that may be near: a good guess saves time
    Found nearest(const Vector3d& p, int near = 0) const;

    /// The nearest points of triangles within a distance of p that no neighbouring triangle comes
    /// nearer at: one on each face, edge or corner that p looks at squarely. The nearest first.
    std::vector<Found> local_minima(const Vector3d& p, double within) const;

    const BoundingTree& tree() const { return tree_; }

private:
    void descend(int index, const Vector3d& p, Found& best) const;
    bool is_on(const Found& found, int triangle) const;

    const TriangleMesh& mesh_;
    BoundingTree tree_;
};

} // namespace rigor
