// SPDX-License-Identifier: MIT
#include "rigid/bodies/union_find.hpp"

#include "support/catch.hpp"

using namespace rigor;

TEST_CASE("union find: what is united has one representative and what is not has two", "[rigid]")
{
    UnionFind sets(8);
    for (int i = 0; i < 8; ++i)
        REQUIRE(sets.find(i) == i);
    sets.unite(0, 1);
    sets.unite(2, 3);
    sets.unite(3, 1);
    sets.unite(6, 5);
    for (int i : {1, 2, 3})
        CHECK(sets.find(i) == sets.find(0));
    CHECK(sets.find(5) == sets.find(6));
    CHECK(sets.find(5) != sets.find(0));
    CHECK(sets.find(4) == 4);
    CHECK(sets.find(7) == 7);
}
