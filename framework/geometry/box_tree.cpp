// SPDX-License-Identifier: MIT
#include "geometry/box_tree.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

BoxTree::BoxTree(const std::vector<Bounds>& boxes, std::vector<int> members)
    : boxes_(boxes), members_(std::move(members))
{
    nodes_.reserve(members_.size());
    if (!members_.empty()) build(0, static_cast<int>(members_.size()));
}

int BoxTree::build(int first, int last)
{
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back({{}, first, last, -1, -1});
    Bounds bounds;
    Bounds centers; // twice
    for (int k = first; k < last; ++k) {
        const Bounds& box = boxes_[members_[k]];
        bounds.include(box);
        const Vector3d center = box.low + box.high;
        centers.include({center, center});
    }
    nodes_[index].bounds = bounds;
    if (last - first <= leaf_size) return index;

    int axis = 0;
    (centers.high - centers.low).maxCoeff(&axis);
    const auto center = [&](int i) { return boxes_[i].low[axis] + boxes_[i].high[axis]; };
    const int middle = first + (last - first) / 2;
    std::nth_element(members_.begin() + first, members_.begin() + middle, members_.begin() + last,
                     [&](int i, int j) {
                         const double a = center(i), b = center(j);
                         return a < b || (a == b && i < j);
                     });
    const int left = build(first, middle);
    const int right = build(middle, last);
    nodes_[index].left = left;
    nodes_[index].right = right;
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
