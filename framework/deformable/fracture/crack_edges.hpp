// SPDX-License-Identifier: MIT
// The points where cracks cut edges of the uncracked mesh, for virtual nodes. A new crack continues
// from these points, so that the crack planes of neighboring elements meet. The formula
// `virtual_nodes` alone decides what a crack does to the mesh.
#pragma once

#include "deformable/solid/deformable.hpp"

#include <map>
#include <utility>

namespace rigor {

class CrackEdges {
public:
    explicit CrackEdges(const Deformable& solid);

    /// A crack of an element that continues the cracks of its neighbors: its plane passes through
    /// points where these cracks cut edges of the element. A plane is possible if
    ///
    ///   * it passes through three of these points, or through two with its normal as near as
    ///     possible to the wanted normal, or through one with the wanted normal,
    ///   * its normal is less than 60° from the wanted normal, and
    ///   * corners with material lie on both sides, none of them almost in the plane.
    ///
    /// The possible planes through the most points are considered, and the one whose normal is
    /// nearest to the wanted normal is taken. If no plane is possible, the crack has the
    /// wanted normal and passes through the mean of the corners with material.
    /// @param parent  the element of the uncracked mesh
    /// @param real    for each corner, 1 if it has material, otherwise 0; at least two corners have
    ///                material, because a crack needs one on each side
    /// @param normal  the wanted normal
    ElementCrack continued(int parent, const std::array<int, 4>& real,
                           const Vector3d& normal) const;

    /// Whether the crack of a neighbor cuts an edge of the element between two corners with
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
