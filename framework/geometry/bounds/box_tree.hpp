// SPDX-License-Identifier: MIT
// A tree of bounding boxes: what overlaps what, without comparing all with all.
#pragma once

#include "geometry/bounds/bounds.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rigor {

/// Boxes, halved again and again along the axis on which their centers are spread most, until few are
/// left: n log n to build. The order of results depends on the boxes alone.
class BoxTree {
public:
    /// @param boxes    finite
    /// @param members  indices of those that belong to it
    BoxTree(const std::vector<Bounds>& boxes, std::vector<int> members);

    /// The same tree, in parts that can be built at the same time.
    /// @param parts  about how many
    /// @param share  share(n, work) calls work(k) for each k in [0, n), in any order or at once
    template <class Share>
    BoxTree(const std::vector<Bounds>& boxes, std::vector<int> members, std::size_t parts,
            const Share& share)
        : members_(std::move(members)), boxes_(members_.size()), along_(members_.size())
    {
        if (members_.empty()) return;
        const int n = static_cast<int>(members_.size()), leaves = leaves_of(n);
        leaves_.resize(leaves);
        nodes_.resize(2 * leaves - 1);
        std::vector<Branch> branches = {{0, 0, 0, n}};
        std::vector<int> above; // the nodes above these branches
        while (branches.size() < parts && !branches[0].is_leaf()) {
            std::vector<Branch> halves;
            for (const Branch& branch : branches) {
                if (branch.is_leaf()) {
                    halves.push_back(branch);
                    continue;
                }
                for (const Branch& half : halve(boxes, branch))
                    halves.push_back(half);
                above.push_back(branch.node);
            }
            branches = std::move(halves);
        }
        share(static_cast<int>(branches.size()), [&](int k) { build(boxes, branches[k]); });
        for (; !above.empty(); above.pop_back())
            close(above.back());
    }

    /// Calls visit(i) for each member whose box overlaps `bounds`.
    template <class Visit> void for_each_overlap(const Bounds& bounds, const Visit& visit) const
    {
        if (nodes_.empty()) return;
        std::array<int, 64> open; // a node for each level, and one more
        int size = 0;
        open[size++] = 0;
        while (size > 0) {
            const Node& node = nodes_[open[--size]];
            if (!node.bounds.overlaps(bounds)) continue;
            for (int k = node.first; k < node.last && node.is_leaf(); ++k)
                if (boxes_[k].overlaps(bounds)) visit(members_[k]);
            if (node.is_leaf()) continue;
            open[size++] = node.right;
            open[size++] = node.left;
        }
    }

    /// Two nodes, whose members may overlap each other's; or one node twice.
    using NodePair = std::pair<int, int>;

    /// Calls visit(i, j) once for each two members whose boxes overlap.
    template <class Visit> void for_each_pair(const Visit& visit) const
    {
        if (!nodes_.empty()) for_each_pair({0, 0}, visit);
    }

    /// The same for the members of these nodes alone.
    template <class Visit> void for_each_pair(const NodePair& nodes, const Visit& visit) const
    {
        std::vector<NodePair> open{nodes};
        open.reserve(128);
        while (!open.empty()) {
            const NodePair next = open.back();
            open.pop_back();
            const Node &p = nodes_[next.first], &q = nodes_[next.second];
            if (next.first == next.second && p.is_leaf())
                within(p, visit);
            else if (next.first != next.second && p.is_leaf() && q.is_leaf())
                between(p, q, visit);
            else
                divide(next, open);
        }
    }

    /// The whole in parts: at least `least` pairs of nodes, if there are as many. Together they have each
    /// two members whose boxes overlap once.
    std::vector<NodePair> parts(std::size_t least) const;

private:
    static constexpr int leaf_size = 4;

    struct Node {
        Bounds bounds;
        int first = 0, last = 0;   // its members
        int left = -1, right = -1; // none: a leaf
        int leaf = -1;
        bool is_leaf() const { return left < 0; }
    };

    // Side by side in a register.
    using Numbers [[gnu::vector_size(16)]] = float;
    using Mask [[gnu::vector_size(16)]] = std::int32_t;
    static bool any(const Mask& mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

    // The boxes of a leaf; where it has fewer than four, nothing. Rounding keeps numbers in their order: what
    // overlaps still does.
    struct Leaf {
        std::array<Numbers, 3> low, high;

        void take(std::span<const Bounds> boxes);

        // Which of these may overlap box k of another leaf.
        Mask near(const Leaf& other, int k) const
        {
            const auto overlap = [&](int axis) {
                const float l = other.low[axis][k], h = other.high[axis][k];
                return (Numbers{l, l, l, l} <= high[axis]) & (low[axis] <= Numbers{h, h, h, h});
            };
            return overlap(0) & overlap(1) & overlap(2);
        }
    };

    // Members that become a node and all below it, and where these are put: n leaves have n - 1 nodes above
    // them, and a node comes before what is below it.
    struct Branch {
        int node = 0, leaf = 0;  // the first of each
        int first = 0, last = 0; // members
        bool is_leaf() const { return last - first <= leaf_size; }
    };
    static int leaves_of(int members);

    // A member, and twice its center along the axis that is halved.
    struct Along {
        double center = 0;
        int member = 0;
    };

    std::array<Branch, 2> halve(const std::vector<Bounds>& boxes, const Branch& branch);
    void build(const std::vector<Bounds>& boxes, const Branch& branch);
    void close(int node); // when what is below it is built

    // Appends what a pair of nodes, not both leaves, consists of; without those that do not overlap.
    void divide(const NodePair& nodes, std::vector<NodePair>& parts) const
    {
        const auto add = [&](int a, int b) {
            if (a == b || nodes_[a].bounds.overlaps(nodes_[b].bounds)) parts.emplace_back(a, b);
        };
        const auto [a, b] = nodes;
        const Node &p = nodes_[a], &q = nodes_[b];
        if (a == b) {
            add(p.left, p.left);
            add(p.left, p.right);
            add(p.right, p.right);
        } else if (q.is_leaf() || (!p.is_leaf() && p.last - p.first >= q.last - q.first)) {
            add(p.left, b);
            add(p.right, b);
        } else {
            add(a, q.left);
            add(a, q.right);
        }
    }

    // Calls visit(k, l) for what overlaps of two leaves, k of p and l of q: four at once, and then exactly.
    template <class Visit> void compare(const Node& p, const Node& q, const Visit& visit) const
    {
        const Leaf &a = leaves_[p.leaf], &b = leaves_[q.leaf];
        for (int k = p.first; k < p.last; ++k) {
            const Mask near = b.near(a, k - p.first);
            if (!any(near)) continue;
            for (int l = q.first; l < q.last; ++l)
                if (near[l - q.first] != 0 && boxes_[k].overlaps(boxes_[l])) visit(k, l);
        }
    }
    template <class Visit> void within(const Node& p, const Visit& visit) const
    {
        compare(p, p, [&](int k, int l) {
            if (k < l) visit(members_[k], members_[l]);
        });
    }
    template <class Visit> void between(const Node& p, const Node& q, const Visit& visit) const
    {
        compare(p, q, [&](int k, int l) { visit(members_[k], members_[l]); });
    }

    std::vector<int> members_;  // leaf after leaf
    std::vector<Bounds> boxes_; // of the members, in their order
    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
    std::vector<Along> along_; // memory of halve
};

} // namespace rigor
