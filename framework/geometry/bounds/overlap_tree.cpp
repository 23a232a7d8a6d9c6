// SPDX-License-Identifier: MIT
// Finds all pairs of boxes that overlap. A tree is compared with itself, node by node from the root
// (Ericson 2005, "Real-time collision detection", 6.3). A pair of nodes whose boxes overlap is
// divided until both are leaves. Then each box of one leaf is compared with the four boxes of the
// other at once, in single precision; no pair is missed, because rounding is monotone. The pairs
// that remain are compared in double precision.
#include "geometry/bounds/overlap_tree.hpp"

#include <algorithm>
#include <limits>

namespace rigor {

void OverlapTree::Leaf::fill(std::span<const Bounds> boxes)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const auto rounded = [](double d) {
        constexpr double largest = std::numeric_limits<float>::max();
        return static_cast<float>(std::clamp(d, -largest, largest));
    };
    for (int axis = 0; axis < 3; ++axis)
        for (std::size_t k = 0; k < BoundingTree::leaf_size; ++k) {
            const bool is_there = k < boxes.size();
            low[axis][k] = is_there ? rounded(boxes[k].low[axis]) : infinity;
            high[axis][k] = is_there ? rounded(boxes[k].high[axis]) : -infinity;
        }
}

OverlapTree::OverlapTree(const std::vector<Bounds>& boxes, std::vector<int> members)
    : OverlapTree(boxes, std::move(members), 1, [](int, const auto& work) { work(0); })
{
}

// Fills the leaves in one stretch of the list of nodes. The list is divided into `stretches` equal
// stretches, and `stretch` is the index of the stretch to fill.
void OverlapTree::fill_leaves(const std::vector<Bounds>& boxes, int stretches, int stretch)
{
    const std::size_t n = tree_.nodes().size();
    for (std::size_t i = n * stretch / stretches; i < n * (stretch + 1) / stretches; ++i) {
        const Node& node = tree_.nodes()[i];
        if (!node.is_leaf()) continue;
        for (int k = node.first; k < node.last; ++k)
            boxes_[k] = boxes[tree_.order()[k]];
        leaves_[node.leaf].fill(std::span(boxes_).subspan(node.first, node.last - node.first));
    }
}

std::vector<OverlapTree::NodePair> OverlapTree::parts(std::size_t least) const
{
    std::vector<NodePair> parts;
    if (!tree_.empty()) parts.emplace_back(0, 0);
    for (bool any = true; any && parts.size() < least;) {
        any = false;
        std::vector<NodePair> finer;
        for (const NodePair& nodes : parts) {
            const bool can_be_divided =
                !tree_.nodes()[nodes.first].is_leaf() || !tree_.nodes()[nodes.second].is_leaf();
            if (can_be_divided)
                divide(nodes, finer);
            else
                finer.push_back(nodes);
            any |= can_be_divided;
        }
        parts = std::move(finer);
    }
    return parts;
}

} // namespace rigor
