// SPDX-License-Identifier: MIT
#include "geometry/bounds/box_tree.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rigor {

void BoxTree::Leaf::take(std::span<const Bounds> boxes)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const auto rounded = [](double d) {
        constexpr double largest = std::numeric_limits<float>::max();
        return static_cast<float>(std::clamp(d, -largest, largest));
    };
    for (int axis = 0; axis < 3; ++axis)
        for (std::size_t k = 0; k < leaf_size; ++k) {
            const bool is_there = k < boxes.size();
            low[axis][k] = is_there ? rounded(boxes[k].low[axis]) : infinity;
            high[axis][k] = is_there ? rounded(boxes[k].high[axis]) : -infinity;
        }
}

BoxTree::BoxTree(const std::vector<Bounds>& boxes, std::vector<int> members)
    : BoxTree(boxes, std::move(members), 1, [](int, const auto& work) { work(0); })
{
}

// After d halvings there are 2^d parts, some of one member more than the others; as soon as the smaller ones
// are leaves, those of leaf_size + 1 are halved once more.
int BoxTree::leaves_of(int members)
{
    int parts = 1;
    while (members / parts > leaf_size)
        parts *= 2;
    const bool are_halved = members / parts == leaf_size;
    return parts + (are_halved ? members % parts : 0);
}

std::array<BoxTree::Branch, 2> BoxTree::halve(const std::vector<Bounds>& boxes,
                                              const Branch& branch)
{
    const auto [node, leaf, first, last] = branch;
    Bounds centers; // twice
    for (int k = first; k < last; ++k) {
        const Bounds& box = boxes[members_[k]];
        const Vector3d center = box.low + box.high;
        centers.include({center, center});
    }
    int axis = 0;
    (centers.high - centers.low).maxCoeff(&axis);
    for (int k = first; k < last; ++k) {
        const Bounds& box = boxes[members_[k]];
        along_[k] = {box.low[axis] + box.high[axis], members_[k]};
    }
    const int middle = first + (last - first) / 2;
    std::nth_element(along_.begin() + first, along_.begin() + middle, along_.begin() + last,
                     [](const Along& a, const Along& b) {
                         return a.center < b.center ||
                                (a.center == b.center && a.member < b.member);
                     });
    for (int k = first; k < last; ++k)
        members_[k] = along_[k].member;
    const int leaves_before = leaves_of(middle - first);
    nodes_[node].left = node + 1;
    nodes_[node].right = node + 2 * leaves_before;
    return {{{nodes_[node].left, leaf, first, middle},
             {nodes_[node].right, leaf + leaves_before, middle, last}}};
}

void BoxTree::build(const std::vector<Bounds>& boxes, const Branch& branch)
{
    if (branch.is_leaf()) {
        const auto [node, leaf, first, last] = branch;
        nodes_[node].leaf = leaf;
        nodes_[node].first = first;
        nodes_[node].last = last;
        for (int k = first; k < last; ++k) {
            boxes_[k] = boxes[members_[k]];
            nodes_[node].bounds.include(boxes_[k]);
        }
        leaves_[leaf].take(std::span(boxes_).subspan(first, last - first));
        return;
    }
    for (const Branch& half : halve(boxes, branch))
        build(boxes, half);
    close(branch.node);
}

void BoxTree::close(int node)
{
    Node& whole = nodes_[node];
    const Node &left = nodes_[whole.left], &right = nodes_[whole.right];
    whole.first = left.first;
    whole.last = right.last;
    whole.bounds = left.bounds;
    whole.bounds.include(right.bounds);
}

std::vector<BoxTree::NodePair> BoxTree::parts(std::size_t least) const
{
    std::vector<NodePair> parts;
    if (!nodes_.empty()) parts.emplace_back(0, 0);
    for (bool any = true; any && parts.size() < least;) {
        any = false;
        std::vector<NodePair> finer;
        for (const NodePair& nodes : parts) {
            const bool can_be_divided =
                !nodes_[nodes.first].is_leaf() || !nodes_[nodes.second].is_leaf();
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
