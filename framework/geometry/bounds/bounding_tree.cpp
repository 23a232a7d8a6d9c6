// SPDX-License-Identifier: MIT
// Builds a tree of bounding boxes from the top down. Each node's items are divided at the median of
// their centers, on the axis on which the centers are spread most (Ericson 2005, "Real-time
// collision detection", 6.2). First the upper nodes are made, then the branches below them, which
// several threads can build at the same time, and last the boxes of the upper nodes.
#include "geometry/bounds/bounding_tree.hpp"

#include <algorithm>
#include <numeric>

namespace rigor {

namespace {

std::vector<int> all_items(std::size_t n)
{
    std::vector<int> items(n);
    std::iota(items.begin(), items.end(), 0);
    return items;
}

} // namespace

BoundingTree::BoundingTree(const std::vector<Bounds>& boxes)
    : BoundingTree(boxes, all_items(boxes.size()), 1, [](int, const auto& work) { work(0); })
{
}

// The number of leaves of a tree of `items` items. After d halvings there are 2^d parts, some of
// them with one item more than the others. If the smaller parts have exactly leaf_size items, the
// larger ones have one too many for a leaf, and are halved once more.
int BoundingTree::leaves_of(int items)
{
    int parts = 1;
    while (items / parts > leaf_size)
        parts *= 2;
    const bool are_halved = items / parts == leaf_size;
    return parts + (are_halved ? items % parts : 0);
}

std::array<BoundingTree::Branch, 2> BoundingTree::halve(const std::vector<Bounds>& boxes,
                                                        const Branch& branch,
                                                        std::vector<Center>& centers)
{
    const auto [node, leaf, first, last] = branch;
    Bounds spread; // the bounds of twice the centers
    for (int k = first; k < last; ++k) {
        const Bounds& box = boxes[order_[k]];
        const Vector3d center = box.low + box.high;
        spread.include({center, center});
    }
    int axis = 0;
    (spread.high - spread.low).maxCoeff(&axis);
    for (int k = first; k < last; ++k) {
        const Bounds& box = boxes[order_[k]];
        centers[k] = {box.low[axis] + box.high[axis], order_[k]};
    }
    const int middle = first + (last - first) / 2;
    std::nth_element(centers.begin() + first, centers.begin() + middle, centers.begin() + last,
                     [](const Center& a, const Center& b) {
                         return a.twice < b.twice || (a.twice == b.twice && a.item < b.item);
                     });
    for (int k = first; k < last; ++k)
        order_[k] = centers[k].item;
    const int leaves_left = leaves_of(middle - first);
    const int left = node + 1, right = node + 2 * leaves_left;
    nodes_[node].right = right;
    return {{{left, leaf, first, middle}, {right, leaf + leaves_left, middle, last}}};
}

void BoundingTree::build(const std::vector<Bounds>& boxes, const Branch& branch,
                         std::vector<Center>& centers)
{
    if (branch.is_leaf()) {
        Node& node = nodes_[branch.node];
        node.leaf = branch.leaf;
        node.first = branch.first;
        node.last = branch.last;
        for (int k = branch.first; k < branch.last; ++k)
            node.bounds.include(boxes[order_[k]]);
        return;
    }
    for (const Branch& half : halve(boxes, branch, centers))
        build(boxes, half, centers);
    unite_children(branch.node);
}

void BoundingTree::unite_children(int index)
{
    Node& node = nodes_[index];
    const Node &left = nodes_[index + 1], &right = nodes_[node.right];
    node.first = left.first;
    node.last = right.last;
    node.bounds = left.bounds;
    node.bounds.include(right.bounds);
}

} // namespace rigor
