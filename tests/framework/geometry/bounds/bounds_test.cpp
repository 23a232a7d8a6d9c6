// SPDX-License-Identifier: MIT
#include "geometry/bounds/bounds.hpp"
#include "support/close.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("bounds: those that share a face overlap and those apart do not", "[geometry]")
{
    const Bounds a{{0, 0, 0}, {1, 1, 1}}, touching{{1, 0, 0}, {2, 1, 1}},
        apart{{1.1, 0, 0}, {2, 1, 1}};
    CHECK(a.overlaps(touching));
    CHECK_FALSE(a.overlaps(apart));
    Bounds grown = a;
    grown.grow(0.2);
    CHECK(grown.overlaps(apart));
    CHECK_FALSE(Bounds().overlaps(a)); // empty bounds overlap nothing
}
