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

    /// The crack of an element whose normal is as near as possible to the wanted one and whose
    /// plane passes through the cuts that cracks of neighbours made on its edges: through three,
    /// two or one of them, as many as leave its normal less than 60° from the wanted one; else
    /// through the middle.
    /// @param parent  the element of the uncracked mesh
    /// @param real    1 for the corners with matter, at least two, which the crack is to separate
    ElementCrack continued(int parent, const std::array<int, 4>& real,
                           const Vector3d& normal) const;

    /// Whether a neighbour's crack cuts an edge between two of these corners.
    bool meets(int parent, const std::array<int, 4>& real) const;

    /// Whether the element already has a crack whose normal is less than 45° from this one.
    bool has_similar(int parent, const Vector3d& normal) const;

private:
    std::vector<Vector3d> cuts(int parent, const std::array<int, 4>& real) const;

    const Deformable& solid_;
    std::map<std::pair<int, int>, Vector3d>
        cuts_; // the cut on each edge, whose vertices are ascending [m]
    std::vector<std::vector<int>> cracks_of_; // for each element
};

} // namespace rigor
