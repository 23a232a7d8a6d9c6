// SPDX-License-Identifier: MIT
// The points where cracks cut edges of the uncracked mesh, for virtual nodes. A new crack continues
// from these points, so that the crack planes of neighbouring elements meet. The formula
// `virtual_nodes` alone decides what a crack does to the mesh.
#pragma once

#include "deformable/solid/deformable.hpp"

#include <map>
#include <utility>

namespace rigor {

class CrackEdges {
public:
    explicit CrackEdges(const Deformable& solid);

    /// A crack of an element that continues the cracks of its neighbours. Its plane passes through
    /// the points where these cracks cut edges of the element: through three, two or one of them,
    /// as many as possible while its normal stays less than 60° from the wanted one and it has
    /// corners with material on both sides. Among planes through the same number of points, it is
    /// the one whose normal is nearest to the wanted one. If there is no such plane, the crack has
    /// the wanted normal and passes through the mean of the corners with material.
    /// @param parent  the element of the uncracked mesh
    /// @param real    for each corner, 1 if it has material, as at least two corners must have
    /// @param normal  the wanted normal
    ElementCrack continued(int parent, const std::array<int, 4>& real,
                           const Vector3d& normal) const;

    /// Whether the crack of a neighbour cuts an edge of the element between two corners with
    /// material.
    bool meets(int parent, const std::array<int, 4>& real) const;

    /// Whether the element already has a crack whose normal is less than about 45° from this
    /// normal.
    bool has_similar(int parent, const Vector3d& normal) const;

private:
    std::vector<Vector3d> cuts(int parent, const std::array<int, 4>& real) const;

    const Deformable& solid_;
    // For each edge that is cut, the point of the cut [m]. The key is the two vertices of the edge,
    // in ascending order.
    std::map<std::pair<int, int>, Vector3d> cuts_;
    // For each element of the uncracked mesh, the indices of its cracks in `Deformable::cracks`.
    std::vector<std::vector<int>> cracks_of_;
};

} // namespace rigor
