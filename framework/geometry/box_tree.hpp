// SPDX-License-Identifier: MIT
// A tree of bounding boxes: what overlaps what, without comparing all with all.
#pragma once

#include "geometry/bounds.hpp"

#include <array>
#include <vector>

namespace rigor {

/// Boxes, halved again and again along the axis on which their centers are spread most, until few are
/// left: n log n to build. The order of results depends on the boxes alone.
class BoxTree {
public:
    /// @param boxes    finite; they must outlive the tree
    /// @param members  indices of those that belong to it
    BoxTree(const std::vector<Bounds>& boxes, std::vector<int> members);

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
                if (boxes_[members_[k]].overlaps(bounds)) visit(members_[k]);
            if (node.is_leaf()) continue;
            open[size++] = node.right;
            open[size++] = node.left;
        }
    }

    /// Calls visit(i, j) once for each two members whose boxes overlap.
    template <class Visit> void for_each_pair(const Visit& visit) const
    {
        if (nodes_.empty()) return;
        std::vector<std::pair<int, int>> open;
        open.reserve(128);
        open.emplace_back(0, 0);
        while (!open.empty()) {
            const auto [a, b] = open.back();
            open.pop_back();
            const Node &p = nodes_[a], &q = nodes_[b];
            if (a == b) {
                if (p.is_leaf()) {
                    within(p, visit);
                    continue;
                }
                open.emplace_back(p.left, p.left);
                open.emplace_back(p.left, p.right);
                open.emplace_back(p.right, p.right);
            } else if (!p.bounds.overlaps(q.bounds)) {
                continue;
            } else if (p.is_leaf() && q.is_leaf()) {
                between(p, q, visit);
            } else if (q.is_leaf() || (!p.is_leaf() && p.last - p.first >= q.last - q.first)) {
                open.emplace_back(p.left, b);
                open.emplace_back(p.right, b);
            } else {
                open.emplace_back(a, q.left);
                open.emplace_back(a, q.right);
            }
        }
    }

private:
    static constexpr int leaf_size = 4;

    struct Node {
        Bounds bounds;
        int first = 0, last = 0;   // its members
        int left = -1, right = -1; // none: a leaf
        bool is_leaf() const { return left < 0; }
    };

    int build(int first, int last);

    template <class Visit> void within(const Node& p, const Visit& visit) const
    {
        for (int k = p.first; k < p.last; ++k)
            for (int l = k + 1; l < p.last; ++l)
                if (boxes_[members_[k]].overlaps(boxes_[members_[l]]))
                    visit(members_[k], members_[l]);
    }
    template <class Visit> void between(const Node& p, const Node& q, const Visit& visit) const
    {
        for (int k = p.first; k < p.last; ++k) {
            const Bounds& box = boxes_[members_[k]];
            if (!box.overlaps(q.bounds)) continue;
            for (int l = q.first; l < q.last; ++l)
                if (box.overlaps(boxes_[members_[l]])) visit(members_[k], members_[l]);
        }
    }

    const std::vector<Bounds>& boxes_;
    std::vector<int> members_;
    std::vector<Node> nodes_;
};

} // namespace rigor
