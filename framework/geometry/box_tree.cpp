// SPDX-License-Identifier: MIT
#include "geometry/box_tree.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rigor {

BoxTree::Leaf::Leaf(std::span<const Bounds> boxes)
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
    : members_(std::move(members))
{
    nodes_.reserve(members_.size());
    boxes_.reserve(members_.size());
    if (!members_.empty()) build(boxes, 0, static_cast<int>(members_.size()));
}

int BoxTree::build(const std::vector<Bounds>& boxes, int first, int last)
{
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back({{}, first, last, -1, -1});
    if (last - first <= leaf_size) {
        for (int k = first; k < last; ++k) {
            boxes_.push_back(boxes[members_[k]]);
            nodes_[index].bounds.include(boxes_[k]);
        }
        nodes_[index].leaf = static_cast<int>(leaves_.size());
        leaves_.emplace_back(std::span(boxes_).subspan(first, last - first));
        return index;
    }

    Bounds centers; // twice
    for (int k = first; k < last; ++k) {
        const Bounds& box = boxes[members_[k]];
        const Vector3d center = box.low + box.high;
        centers.include({center, center});
    }
    int axis = 0;
    (centers.high - centers.low).maxCoeff(&axis);
    const auto center = [&](int i) { return boxes[i].low[axis] + boxes[i].high[axis]; };
    const int middle = first + (last - first) / 2;
    std::nth_element(members_.begin() + first, members_.begin() + middle, members_.begin() + last,
                     [&](int i, int j) {
                         const double a = center(i), b = center(j);
                         return a < b || (a == b && i < j);
                     });
    const int left = build(boxes, first, middle);
    const int right = build(boxes, middle, last);
    Node& node = nodes_[index];
    node.left = left;
    node.right = right;
    node.bounds = nodes_[left].bounds;
    node.bounds.include(nodes_[right].bounds);
    return index;
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
