// SPDX-License-Identifier: MIT
#include "geometry/bounds/overlap_tree.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("overlap tree: it finds what comparing all pairs finds", "[geometry]")
{
    // The sizes of the boxes reach from nearly the smallest to nearly the largest double. Some
    // boxes touch, or are apart by one rounding error far from the origin.
    const double scale = GENERATE(1.0, 1e-300, 1e-40, 1e30, 1e300);
    const double far = GENERATE(0.0, 1e6);
    CAPTURE(scale, far);
    Random random(11);
    std::vector<Bounds> boxes;
    std::vector<int> members;
    for (int i = 0; i < 300; ++i) {
        const Vector3d low = Vector3d::Constant(far) + 5 * random.vector();
        boxes.push_back({scale * low, scale * (low + Vector3d::Constant(random.uniform(0, 1.5)))});
        if (i % 5 > 2) { // this box begins where the previous one ends
            Bounds& box = boxes.back();
            box.high.x() -= box.low.x();
            box.low.x() = boxes[i - 1].high.x();
            if (i % 5 == 3) box.low.x() = std::nextafter(box.low.x(), 1e308);
            box.high.x() += box.low.x();
        }
        if (i % 7) members.push_back(i);
    }
    std::vector<std::pair<int, int>> found, expected;
    const OverlapTree tree(boxes, members);
    tree.for_each_pair([&](int i, int j) { found.push_back(std::minmax(i, j)); });
    for (std::size_t a = 0; a < members.size(); ++a)
        for (std::size_t b = a + 1; b < members.size(); ++b)
            if (boxes[members[a]].overlaps(boxes[members[b]]))
                expected.emplace_back(members[a], members[b]);
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    REQUIRE(expected.size() > 50);
    CHECK(found == expected);
}

TEST_CASE("overlap tree: one built in parts is the same tree", "[geometry]")
{
    const std::size_t parts = GENERATE(1u, 2u, 5u, 64u);
    CAPTURE(parts);
    Random random(12);
    std::vector<Bounds> boxes;
    for (int n = 0; n < 70; ++n) {
        CAPTURE(n);
        std::vector<int> members(n);
        std::iota(members.begin(), members.end(), 0);
        using Pairs = std::vector<std::pair<int, int>>;
        const auto pairs_of = [](const OverlapTree& tree) {
            Pairs pairs;
            tree.for_each_pair([&](int i, int j) { pairs.emplace_back(i, j); });
            return pairs;
        };
        const auto last_first = [](int tasks, const auto& work) {
            for (int k = tasks - 1; k >= 0; --k)
                work(k);
        };
        const Pairs whole = pairs_of(OverlapTree(boxes, members));
        CHECK(pairs_of(OverlapTree(boxes, members, parts, last_first)) == whole);
        std::size_t overlaps = 0;
        for (int i = 0; i < n; ++i)
            for (int j = i + 1; j < n; ++j)
                overlaps += boxes[i].overlaps(boxes[j]);
        CHECK(whole.size() == overlaps);
        const Vector3d low = 2 * random.vector();
        boxes.push_back({low, low + Vector3d::Constant(random.uniform(0, 1.5))});
    }
}
