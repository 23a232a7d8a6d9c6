// SPDX-License-Identifier: MIT
// A tree of bounding boxes over many small things, to find those that are near.
#pragma once

#include "geometry/bounds/bounds.hpp"

#include <vector>

namespace rigor {

/// A binary tree of axis-aligned boxes over items 0 … n-1, halved at the median of the longest axis.
class BoundingTree {
public:
    /// Children of node i are i + 1 and `right`; a leaf has none (right = 0) and holds the items
    /// order[first] … order[last - 1].
    struct Node {
        Bounds bounds;
        int first = 0, last = 0, right = 0;
        bool is_leaf() const { return right == 0; }
    };

    BoundingTree() = default;
    explicit BoundingTree(const std::vector<Bounds>& items);

    bool empty() const { return nodes_.empty(); }
    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<int>& order() const { return order_; }

    /// Calls visit(item) for the items of each leaf whose box, and whose parents' boxes, enter(box)
    /// lets in; always in the same order.
    template <class Enter, class Visit> void walk(const Enter& enter, const Visit& visit) const
    {
        if (!nodes_.empty()) walk(0, enter, visit);
    }

    /// Calls visit(item) for each item whose leaf's box overlaps `bounds`.
    template <class Visit> void near(const Bounds& bounds, const Visit& visit) const
    {
        walk([&](const Bounds& box) { return box.overlaps(bounds); }, visit);
    }

private:
    void build(const std::vector<Bounds>& items, int first, int last);

    template <class Enter, class Visit>
    void walk(int index, const Enter& enter, const Visit& visit) const
    {
        const Node& node = nodes_[index];
        if (!enter(node.bounds)) return;
        if (node.is_leaf()) {
            for (int i = node.first; i < node.last; ++i)
                visit(order_[i]);
            return;
        }
        walk(index + 1, enter, visit);
        walk(node.right, enter, visit);
    }

    std::vector<Node> nodes_;
    std::vector<int> order_;
};

/// Squared distance from a point to a box, 0 inside [m²].
inline double squared_distance(const Bounds& box, const Vector3d& p)
{
    return (p - p.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
}

} // namespace rigor
