// SPDX-License-Identifier: MIT
// Where cracks of virtual nodes cut the edges of the uncracked mesh: a new crack goes on from there, so
// that the planes of neighbouring elements meet. What a crack does to the mesh is `virtual_nodes`' alone.
#pragma once

#include "deformable/solid/deformable.hpp"

#include <map>
#include <utility>

namespace rigor {

class CrackEdges {
public:
    explicit CrackEdges(const Deformable& solid);

    /// The crack of an element, of the wanted normal as nearly as it can be, that passes through the cuts
    /// which its neighbours' cracks made on its edges: through three of them, two or one, if its normal
    /// is then less than 60° from the wanted one; else through the middle.
    /// @param parent  of the uncracked mesh
    /// @param real    the corners that are to come apart, at least two
    ElementCrack continued(int parent, const std::array<int, 4>& real,
                           const Vector3d& normal) const;

    /// Whether a neighbour's crack cuts an edge between two of these corners.
    bool meets(int parent, const std::array<int, 4>& real) const;

    /// Whether the element has such a crack already: one that is less than 45° from it.
    bool has_similar(int parent, const Vector3d& normal) const;

private:
    std::vector<Vector3d> cuts(int parent, const std::array<int, 4>& real) const;

    const Deformable& solid_;
    std::map<std::pair<int, int>, Vector3d> cuts_; // of edges, by their vertices, ascending
    std::vector<std::vector<int>> cracks_of_;      // of each element
};

} // namespace rigor
