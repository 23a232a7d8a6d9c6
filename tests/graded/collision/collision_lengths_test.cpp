// SPDX-License-Identifier: MIT
// A4.11: lists of every length, with the deepest contact that approaches anywhere in them.
#include "formulas/collision.hpp"
#include "graded/laws/lengths.hpp"
#include "support/close.hpp"

namespace collision_lengths_test {

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("collision: the deepest of any number of contacts wherever it is", "[A4.11][collision]")
{
    using Index = std::optional<int>;
    for (const int n : lengths(0, 65536)) {
        CAPTURE(n);
        std::vector<ContactPoint> contacts(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) // the deeper contacts separate
            contacts[i] = {
                {0, 0, 0}, {0, 1, 0}, i % 3 == 0 ? 2.0 : 1.0, {0, i % 3 == 0 ? 1.0 : -1.0, 0}};
        REQUIRE_THAT(deepest_approaching_point(contacts), IsExactly(n > 1 ? Index(1) : Index()));
        for (const int deepest : {n - 1, n / 2, n - 2, 0}) {
            if (deepest < 0 || deepest >= n) continue;
            CAPTURE(deepest);
            const ContactPoint before = contacts[deepest];
            contacts[deepest].depth = 1.5;
            contacts[deepest].relative_velocity.y() = -0x1p-20;
            REQUIRE_THAT(deepest_approaching_point(contacts), IsExactly(Index(deepest)));
            contacts[deepest] = before;
        }
    }
}

} // namespace collision_lengths_test
