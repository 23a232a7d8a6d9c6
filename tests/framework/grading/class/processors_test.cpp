// SPDX-License-Identifier: MIT
#include "grading/class/processors.hpp"

#include "support/catch.hpp"

#include <vector>

namespace rigor::testing {

TEST_CASE("processors: jobs get different ones as long as there are enough", "[class]")
{
    Processors three({4, 7, 9});
    REQUIRE(three.take() == 4);
    REQUIRE(three.take() == 7);
    three.give_back(4);
    REQUIRE(three.take() == 9); // the next one, not the one that has just been given back
    REQUIRE(three.take() == 4);
}

TEST_CASE("processors: more jobs than processors are spread evenly", "[class]")
{
    Processors two({0, 1});
    int jobs[2] = {};
    for (int i = 0; i < 6; ++i)
        ++jobs[two.take()];
    REQUIRE(jobs[0] == 3);
    REQUIRE(jobs[1] == 3);
    two.give_back(1);
    two.give_back(1);
    REQUIRE(two.take() == 1);
    REQUIRE(two.take() == 1);
}

TEST_CASE("processors: without a known processor a job runs anywhere", "[class]")
{
    Processors none(std::vector<int>{});
    REQUIRE(none.take() == -1);
    none.give_back(-1);
    keep_to(-1);
    Processors own;
    REQUIRE(own.take() >= 0);
}

} // namespace rigor::testing
