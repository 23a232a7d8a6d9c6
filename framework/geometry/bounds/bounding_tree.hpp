// SPDX-License-Identifier: MIT
// A tree of bounding boxes. It finds triangles of a mesh, points and edges of its surface, and
// bodies in the broad phase (`overlap_tree.hpp`).
#pragma once

#include "geometry/bounds/bounds.hpp"

#include <array>
#include <utility>
#include <vector>

namespace rigor {

/// A binary tree of axis-aligned boxes. A set of items is halved again and again, at the median of
/// their centers on the axis on which the centers are spread most, until each part has at most four
/// items. Building takes n log n steps. The same boxes and members always give the same tree.
class BoundingTree {
public:
    /// The largest number of items in a leaf: `OverlapTree` compares four boxes at once.
    static constexpr int leaf_size = 4;

    /// A node comes before all nodes below it: the children of node i are i + 1 and `right`.
    struct Node {
        Bounds bounds;
        int first = 0, last = 0; // its items are order[first] … order[last - 1]
        int right = 0;           // index of the right child; 0 in a leaf
        int leaf = 0;            // in a leaf: its index among all leaves, from the left
        bool is_leaf() const { return right == 0; }
    };

    BoundingTree() = default;

    /// A tree over all boxes: item i has the box boxes[i].
    /// @param boxes  boxes with finite corners
    explicit BoundingTree(const std::vector<Bounds>& boxes);

    /// A tree over some of the items, in parts that several threads can build at the same time.
    ///
    /// @param boxes    boxes of all items, finite
    /// @param members  indices of the boxes that belong to the tree
    /// @param parts    how many parts to build at the same time; rounded up to a power of two, but
    ///                 a small tree has fewer parts
    /// @param share    share(n, work) calls work(k) for each k in [0, n), in any order or in
    ///                 parallel
    template <class Share>
    BoundingTree(const std::vector<Bounds>& boxes, std::vector<int> members, std::size_t parts,
                 const Share& share)
        : order_(std::move(members))
    {
        if (order_.empty()) return;
        const int n = static_cast<int>(order_.size());
        nodes_.resize(2 * leaves_of(n) - 1);
        std::vector<Center> centers(order_.size());
        std::vector<Branch> branches = {{0, 0, 0, n}};
        std::vector<int> above; // the nodes above the `branches`, parents before their children
        while (branches.size() < parts && !branches[0].is_leaf()) {
            std::vector<Branch> halves;
            for (const Branch& branch : branches) {
                if (branch.is_leaf()) {
                    halves.push_back(branch);
                    continue;
                }
                for (const Branch& half : halve(boxes, branch, centers))
                    halves.push_back(half);
                above.push_back(branch.node);
            }
            branches = std::move(halves);
        }
        share(static_cast<int>(branches.size()),
              [&](int k) { build(boxes, branches[k], centers); });
        for (; !above.empty(); above.pop_back())
            unite_children(above.back());
    }

    bool empty() const { return nodes_.empty(); }
    const std::vector<Node>& nodes() const { return nodes_; }

    /// The indices of the items, leaf after leaf.
    const std::vector<int>& order() const { return order_; }

    /// Calls visit(item) for the items of each leaf if enter(box) is true for the box of the leaf
    /// and for the boxes of all nodes above it. The order is always the same.
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
    // A node with all nodes below it: where these nodes and leaves are stored, and their items. A
    // branch of n leaves has 2 n - 1 nodes, leaves included.
    struct Branch {
        int node = 0, leaf = 0;  // indices of its first node and its first leaf
        int first = 0, last = 0; // its items are order_[first] … order_[last - 1]
        bool is_leaf() const { return last - first <= leaf_size; }
    };

    // An item, and twice the coordinate of its center on the axis on which a branch is halved.
    struct Center {
        double twice = 0;
        int item = 0;
    };

    static int leaves_of(int items);
    std::array<Branch, 2> halve(const std::vector<Bounds>& boxes, const Branch& branch,
                                std::vector<Center>& centers);
    void build(const std::vector<Bounds>& boxes, const Branch& branch,
               std::vector<Center>& centers);
    void unite_children(int node);

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

} // namespace rigor
