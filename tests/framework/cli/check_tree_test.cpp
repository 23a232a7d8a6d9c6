// SPDX-License-Identifier: MIT
// The tree as it is handed out: the reference has every point, the stubs have none.
#include "checked.hpp"
#include "grading/assignment.hpp"
#include "grading/places.hpp"

namespace rigor::testing {

namespace {

/// The tags of the tasks that the reference is checked for. An empty list means all tasks. With
/// sanitizers, scenes of many bodies or elements take 20 to 50 times as long, which is minutes for
/// each. A sanitized build therefore checks only the scenes of A0 and A1; its tests of rigid,
/// deformable and classics run the same engine. Of the formulas it checks every second one, and the
/// others for the next commit.
std::vector<std::string> graded_tags()
{
    std::vector<std::string> tags;
#ifdef RIGOR_SANITIZED
    int turn = 0;
    for (const Assignment& assignment : load_assignments(places().assignments()))
        for (const Task& task : assignment.tasks)
            if (assignment.label() <= "a1" || (!task.formula.empty() && turn++ % 2 == RIGOR_TURN))
                tags.push_back(task.tag);
    REQUIRE(tags.size() > 35);
#endif
    return tags;
}

} // namespace

TEST_CASE("tree: the reference has every point", "[cli][tree]")
{
    if (!places().has_reference()) return; // this is a student's tree
    const Checked checked = check(graded_tags(), "reference");
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

TEST_CASE("tree: every stub is not implemented and none fails or passes", "[cli][submission]")
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
