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
    /// as many as possible while its normal stays less than 60° from the wanted one; otherwise
    /// through the middle of the element. Among such planes, the normal is as near as possible to
    /// the wanted one.
    /// @param parent  the element of the uncracked mesh
    /// @param real    1 for the corners with material, at least two, which the crack has to
    ///                separate
    ElementCrack continued(int parent, const std::array<int, 4>& real,
                           const Vector3d& normal) const;

    /// Whether a neighbour's crack cuts an edge between two of these corners.
    bool meets(int parent, const std::array<int, 4>& real) const;

    /// Whether the element already has a crack whose normal is less than 45° from this one.
    bool has_similar(int parent, const Vector3d& normal) const;

private:
    std::vector<Vector3d> cuts(int parent, const std::array<int, 4>& real) const;

    const Deformable& solid_;
    // The point where each edge is cut, by the two vertices of the edge in ascending order [m].
    std::map<std::pair<int, int>, Vector3d> cuts_;
    std::vector<std::vector<int>> cracks_of_; // for each element
};

} // namespace rigor
