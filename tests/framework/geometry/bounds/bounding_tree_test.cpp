// SPDX-License-Identifier: MIT
#include "geometry/bounds/bounding_tree.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

#include <algorithm>

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("bounding tree: each box is in one leaf and within all nodes above it", "[geometry]")
{
    for (const int n : {0, 1, 4, 5, 37, 200}) {
        CAPTURE(n);
        Random random(3);
        std::vector<Bounds> boxes;
        for (int i = 0; i < n; ++i) {
            const Vector3d low = random.vector();
            boxes.push_back({low, low + Vector3d::Constant(random.uniform(0, 0.3))});
        }
        const BoundingTree tree(boxes);
        std::vector<int> items = tree.order();
        std::sort(items.begin(), items.end());
        REQUIRE(static_cast<int>(items.size()) == n);
        for (int i = 0; i < n; ++i)
            REQUIRE(items[i] == i);
        for (const BoundingTree::Node& node : tree.nodes()) {
            for (int i = node.first; i < node.last; ++i)
                REQUIRE(node.bounds.contains(boxes[tree.order()[i]]));
            if (node.is_leaf()) REQUIRE(node.last - node.first <= BoundingTree::leaf_size);
        }
    }
}

TEST_CASE("bounding tree: no box that overlaps is missed", "[geometry]")
{
    Random random(4);
    std::vector<Bounds> boxes;
    for (int i = 0; i < 150; ++i) {
        const Vector3d low = 2 * random.vector();
        boxes.push_back({low, low + Vector3d::Constant(0.5)});
    }
    const BoundingTree tree(boxes);
    for (const Bounds& box : boxes) {
        std::vector<int> found;
        tree.near(box, [&](int i) { found.push_back(i); });
        for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
            if (box.overlaps(boxes[i])) REQUIRE(std::count(found.begin(), found.end(), i) == 1);
    }
}
