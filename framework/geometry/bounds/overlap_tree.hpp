// SPDX-License-Identifier: MIT
// A tree that finds all pairs of overlapping boxes, for the broad phase.
#pragma once

#include "geometry/bounds/bounding_tree.hpp"

#include <cstdint>
#include <span>

namespace rigor {

/// A bounding tree whose leaves also store their boxes in single precision, each coordinate of four
/// boxes in one vector, so that a box is compared with four others at once. Each pair that overlaps
/// in single precision is then compared in double precision. No pair is missed: rounding keeps
/// numbers in their order, so boxes that overlap still overlap when rounded.
class OverlapTree {
public:
    /// @param boxes    boxes with finite corners
    /// @param members  indices of the boxes that belong to the tree
    OverlapTree(const std::vector<Bounds>& boxes, std::vector<int> members);

    /// Builds the same tree in parts, which several threads can build at the same time. `parts` and
    /// `share` are as in the constructor of `BoundingTree` (bounding_tree.hpp).
    template <class Share>
    OverlapTree(const std::vector<Bounds>& boxes, std::vector<int> members, std::size_t parts,
                const Share& share)
        : tree_(boxes, std::move(members), parts, share), boxes_(tree_.order().size()),
          leaves_((tree_.nodes().size() + 1) / 2)
    {
        if (tree_.empty()) return;
        const int stretches = static_cast<int>(parts < 1 ? 1 : parts);
        share(stretches, [&](int k) { fill_leaves(boxes, stretches, k); });
    }

    /// Calls visit(i) for each member whose box overlaps `bounds`.
    template <class Visit> void for_each_overlap(const Bounds& bounds, const Visit& visit) const
    {
        if (tree_.empty()) return;
        // Nodes still to visit: at most one for each level of the tree, and one more.
        std::array<int, 64> open;
        int size = 0;
        open[size++] = 0;
        while (size > 0) {
            const int index = open[--size];
            const Node& node = tree_.nodes()[index];
            if (!node.bounds.overlaps(bounds)) continue;
            for (int k = node.first; k < node.last && node.is_leaf(); ++k)
                if (boxes_[k].overlaps(bounds)) visit(tree_.order()[k]);
            if (node.is_leaf()) continue;
            open[size++] = node.right;
            open[size++] = index + 1;
        }
    }

    /// Two nodes: a member of the first may overlap a member of the second. A node paired with
    /// itself stands for all pairs of its own members.
    using NodePair = std::pair<int, int>;

    /// Calls visit(i, j) once for each pair of members whose boxes overlap.
    template <class Visit> void for_each_pair(const Visit& visit) const
    {
        if (!tree_.empty()) for_each_pair({0, 0}, visit);
    }

    /// Calls visit(i, j) once for each pair of members whose boxes overlap, i of the first node and
    /// j of the second.
    template <class Visit> void for_each_pair(const NodePair& nodes, const Visit& visit) const
    {
        std::vector<NodePair> open{nodes};
        open.reserve(128);
        while (!open.empty()) {
            const NodePair next = open.back();
            open.pop_back();
            const Node &p = tree_.nodes()[next.first], &q = tree_.nodes()[next.second];
            if (next.first == next.second && p.is_leaf())
                pairs_within(p, visit);
            else if (next.first != next.second && p.is_leaf() && q.is_leaf())
                pairs_between(p, q, visit);
            else
                divide(next, open);
        }
    }

    /// The search for all pairs, divided into parts. A part is a pair of nodes. There are at least
    /// `least` parts, if the tree can be divided into so many. No pair of members belongs to two
    /// parts.
    std::vector<NodePair> parts(std::size_t least) const;

private:
    using Node = BoundingTree::Node;

    // Four numbers in a vector register, and the four results of a comparison: 0 is false.
    using Numbers [[gnu::vector_size(16)]] = float;
    using Mask [[gnu::vector_size(16)]] = std::int32_t;
    static bool any(const Mask& mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

    // The four boxes of a leaf. If a leaf has fewer, boxes that overlap nothing fill the rest.
    struct Leaf {
        std::array<Numbers, 3> low, high;

        void fill(std::span<const Bounds> boxes);

        // For each of these four boxes, whether it may overlap box k of another leaf.
        Mask candidates(const Leaf& other, int k) const
        {
            const auto overlap = [&](int axis) {
                const float l = other.low[axis][k], h = other.high[axis][k];
                return (Numbers{l, l, l, l} <= high[axis]) & (low[axis] <= Numbers{h, h, h, h});
            };
            return overlap(0) & overlap(1) & overlap(2);
        }
    };

    void fill_leaves(const std::vector<Bounds>& boxes, int stretches, int stretch);

    // Divides a pair of nodes that are not both leaves: replaces the node with more members by its
    // two children. Appends the resulting pairs of nodes whose bounds overlap. A node paired with
    // itself is divided into three pairs.
    void divide(const NodePair& nodes, std::vector<NodePair>& parts) const
    {
        const auto add = [&](int a, int b) {
            if (a == b || tree_.nodes()[a].bounds.overlaps(tree_.nodes()[b].bounds))
                parts.emplace_back(a, b);
        };
        const auto [a, b] = nodes;
        const Node &p = tree_.nodes()[a], &q = tree_.nodes()[b];
        if (a == b) {
            add(a + 1, a + 1);
            add(a + 1, p.right);
            add(p.right, p.right);
        } else if (q.is_leaf() || (!p.is_leaf() && p.last - p.first >= q.last - q.first)) {
            add(a + 1, b);
            add(p.right, b);
        } else {
            add(a, b + 1);
            add(a, q.right);
        }
    }

    // Calls visit(k, l) for each box k of leaf p and box l of leaf q that overlap.
    template <class Visit> void compare(const Node& p, const Node& q, const Visit& visit) const
    {
        const Leaf &a = leaves_[p.leaf], &b = leaves_[q.leaf];
        for (int k = p.first; k < p.last; ++k) {
            const Mask candidates = b.candidates(a, k - p.first);
            if (!any(candidates)) continue;
            for (int l = q.first; l < q.last; ++l)
                if (candidates[l - q.first] != 0 && boxes_[k].overlaps(boxes_[l])) visit(k, l);
        }
    }
    template <class Visit> void pairs_within(const Node& p, const Visit& visit) const
    {
        compare(p, p, [&](int k, int l) {
            if (k < l) visit(tree_.order()[k], tree_.order()[l]);
        });
    }
    template <class Visit>
    void pairs_between(const Node& p, const Node& q, const Visit& visit) const
    {
        compare(p, q, [&](int k, int l) { visit(tree_.order()[k], tree_.order()[l]); });
    }

    BoundingTree tree_;
    std::vector<Bounds> boxes_; // boxes of the members, in the order of tree_.order()
    std::vector<Leaf> leaves_;
};

} // namespace rigor
