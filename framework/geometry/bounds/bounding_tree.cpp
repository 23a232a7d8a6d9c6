// SPDX-License-Identifier: MIT
#include "geometry/bounds/bounding_tree.hpp"

#include <algorithm>
#include <numeric>

namespace rigor {

namespace {

constexpr int most_in_leaf = 4;

} // namespace

BoundingTree::BoundingTree(const std::vector<Bounds>& items) : order_(items.size())
{
    if (items.empty()) return;
    std::iota(order_.begin(), order_.end(), 0);
    nodes_.reserve(items.size());
    build(items, 0, static_cast<int>(items.size()));
}

void BoundingTree::build(const std::vector<Bounds>& items, int first, int last)
{
    const std::size_t index = nodes_.size();
    nodes_.push_back({{}, first, last, 0});
    Bounds centers;
    const auto center = [&](int item) -> Vector3d {
        return (items[item].low + items[item].high) / 2;
    };
    for (int i = first; i < last; ++i) {
        nodes_[index].bounds.include(items[order_[i]]);
        centers.include({center(order_[i]), center(order_[i])});
    }
    int axis = 0;
    const double spread = (centers.high - centers.low).maxCoeff(&axis);
    if (last - first <= most_in_leaf || !(spread > 0)) return;

    const int middle = (first + last) / 2;
    const auto at = order_.begin();
    std::nth_element(at + first, at + middle, at + last, [&](int a, int b) {
        const double x = center(a)[axis], y = center(b)[axis];
        return x < y || (x == y && a < b);
    });
    build(items, first, middle);
    nodes_[index].right = static_cast<int>(nodes_.size());
    build(items, middle, last);
}

} // namespace rigor
