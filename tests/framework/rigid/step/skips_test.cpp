// SPDX-License-Identifier: MIT
// Work that a step skips changes nothing, or no more than these tests allow.
#include "framework/rigid/worlds.hpp"
#include "rigid/step/step.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>

namespace skips_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 1.0 / 60; // [s]

} // namespace

TEST_CASE("skips: without islands warm start or early exit stacks stand as with them", "[rigid]")
{
    const auto without =
        GENERATE(&Optimisations::islands, &Optimisations::warm_start, &Optimisations::early_exit);
    World with = stacks(3, 5), other = with;
    with.settings.optimisations.sleep = other.settings.optimisations.sleep = false;
    other.settings.optimisations.*without = false;
    run(with, 120, h);
    run(other, 120, h);
    CHECK(with.counters.warm_starts > 1000);
    CHECK(with.counters.early_exits > 100);
    CHECK(with.counters.islands == 3 * 120);
    if (without == &Optimisations::islands) CHECK(other.counters.islands == 120);
    if (without == &Optimisations::warm_start) CHECK(other.counters.warm_starts == 0);
    if (without == &Optimisations::early_exit) CHECK(other.counters.early_exits == 0);
    // Both stand still up to the tolerance of the sweeps.
    CHECK(largest_distance(with, other) < 1e-6);
}

} // namespace skips_test
