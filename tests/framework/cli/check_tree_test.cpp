// SPDX-License-Identifier: MIT
// The tree as it is handed out: the reference has every point, the stubs have none.
#include "checked.hpp"
#include "grading/places.hpp"

namespace rigor::testing {

TEST_CASE("tree: the reference has every point", "[cli][tree]")
{
    if (!places().has_reference()) return; // this is a student's tree
    const Checked checked = check({}, "reference");
    REQUIRE(checked.result.size() >= 5);
    for (const json& result : checked.result) {
        CAPTURE(result["assignment"].get<std::string>());
        REQUIRE(result["status"] == "graded");
        for (const json& test : result["tests"]) {
            CAPTURE(test.dump());
            REQUIRE(test["status"] == "passed");
        }
        REQUIRE(result["max_score"] > 0);
        REQUIRE(result["score"] == result["max_score"]);
    }
    REQUIRE(checked.status == 0);
}

TEST_CASE("tree: every stub is not implemented and none fails or passes", "[cli][tree]")
{
    if (!places().has_reference()) return; // this is a student's tree with a student's work
    const Checked checked = check({}, "student");
    REQUIRE(checked.result.size() >= 5);
    for (const json& result : checked.result) {
        REQUIRE(result["status"] == "graded");
        REQUIRE(result["score"] == 0);
        REQUIRE(result["max_score"] > 0);
        for (const json& test : result["tests"]) {
            CAPTURE(test.dump());
            REQUIRE(test["status"] == "not_implemented");
        }
    }
    REQUIRE(checked.status == 1);
}

} // namespace rigor::testing
