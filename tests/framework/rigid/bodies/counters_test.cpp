// SPDX-License-Identifier: MIT
#include "rigid/bodies/counters.hpp"

#include "support/catch.hpp"

using namespace rigor;

TEST_CASE("counters: every count is added", "[rigid]")
{
    using Counts = std::array<std::uint64_t, sizeof(Counters) / sizeof(std::uint64_t)>;
    Counts first{}, second{};
    for (std::size_t i = 0; i < first.size(); ++i) {
        first[i] = 1000 * (i + 1);
        second[i] = i + 1;
    }
    Counters sum = std::bit_cast<Counters>(first);
    sum += std::bit_cast<Counters>(second);
    const Counts sums = std::bit_cast<Counts>(sum);
    for (std::size_t i = 0; i < sums.size(); ++i)
        CHECK(sums[i] == 1001 * (i + 1));
    CHECK(sum.steps == 1001); // the first count
}
