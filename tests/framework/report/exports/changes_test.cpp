// SPDX-License-Identifier: MIT
#include "report/exports/changes.hpp"

#include "rows.hpp"
#include "support/catch.hpp"

namespace rigor::testing::changes_test {

TEST_CASE("changes: a submission shows its old and new points and the tasks behind them",
          "[report]")
{
    const Row before = row_of("alice", "graded", 0, 3), after = row_of("alice", "graded", 2, 0);
    REQUIRE(change_text(before, after) == "  alice: 3/5 points → 2/5 points\n"
                                          "    A2.1 mass: failed 0/2 → passed 2/2\n"
                                          "    A2.2 turn: passed 3/3 → not_implemented 0/3\n");
    REQUIRE(change_text(before, before).empty());
    REQUIRE(change_text({}, after) == "  alice: new, 2/5 points\n");
    const Row eve = row_of("alice: 5/5 points; eve", "graded", 2, 0);
    REQUIRE(change_text({}, eve) == "  \"alice: 5/5 points; eve\": new, 2/5 points\n");
}

TEST_CASE("changes: other tasks and other points for a task are changes", "[report]")
{
    const Row before = row_of("bob", "graded", 2, 0);
    Row worth_more = before, other = before;
    worth_more.tasks[1].max_points = 4;
    worth_more.max_points = 6;
    REQUIRE(change_text(before, worth_more) ==
            "  bob: 2/5 points → 2/6 points\n"
            "    A2.2 turn: not_implemented 0/3 → not_implemented 0/4\n");
    other.tasks[1].tag = "A2.3";
    REQUIRE(change_text(before, other) ==
            "  bob: 2/5 points → 2/5 points\n"
            "    A2.3 turn: new, not_implemented 0/3\n"
            "    A2.2 turn: not_implemented 0/3 → no task any more\n");
}

TEST_CASE("changes: of a class, those who keep their points are only counted", "[report]")
{
    const Row a = row_of("a", "graded", 2, 0), b = row_of("b", "graded", 2, 3);
    std::vector<Row> after = {a, b};
    for (Row& row : after) {
        row.tasks[1].max_points = 4;
        row.max_points = 6;
    }
    after[1].tasks[1].points = 4;
    after[1].points = 6;
    REQUIRE(changes_text({a, b}, after) ==
            "  b: 5/5 points → 6/6 points\n"
            "    A2.2 turn: passed 3/3 → passed 4/4\n"
            "1 of 2 submissions changes and 1 only in the maximum; the mean of the points: 3.50 → "
            "4.00\n");
}

TEST_CASE("changes: a status is one and a class is counted", "[report]")
{
    const std::vector<std::optional<Row>> before = {row_of("a", "rejected", 0, 0),
                                                    row_of("b", "graded", 2, 3),
                                                    row_of("c", "internal_error", 0, 0)};
    const std::vector<Row> after = {row_of("a", "graded", 2, 0), row_of("b", "graded", 2, 3),
                                    row_of("c", "graded", 2, 3)};
    const std::string text = changes_text(before, after);
    CAPTURE(text);
    REQUIRE(text == "  a: rejected, 0/5 points → 2/5 points\n"
                    "    A2.1 mass: failed 0/2 → passed 2/2\n"
                    "  c: internal_error → 5/5 points\n"
                    "    A2.1 mass: failed 0/2 → passed 2/2\n"
                    "    A2.2 turn: not_implemented 0/3 → passed 3/3\n"
                    "2 of 3 submissions change; the mean of the points: 5.00 → 4.00\n");
}

} // namespace rigor::testing::changes_test
