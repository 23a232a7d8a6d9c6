// SPDX-License-Identifier: MIT
#include "report/exports/gradebook.hpp"

#include "rows.hpp"
#include "support/catch.hpp"

#include <sstream>
#include <string>

namespace rigor::testing {

namespace {

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("gradebook: a line for each submission and a column for each task", "[report]")
{
    REQUIRE(gradebook_csv(some_class()) ==
            "submission,status,points,max,A2.1,A2.2\r\n"
            "\"Doe, Jane_17_assignsubmission_file\",graded,5,5,2,3\r\n"
            "doejohn_LATE_4711_99_a2.zip,graded,2,5,2,0\r\n"
            "eve,internal_error,,5,,\r\n" // no points, not even zero
            "mallory,rejected,0,5,0,0\r\n"
            "zed,compile_error,0,5,0,0\r\n");
}

TEST_CASE("gradebook: the summary counts tasks and points and names who has no grade", "[report]")
{
    const std::string text = class_summary(some_class());
    CAPTURE(text);
    CHECK(contains(text, "a2-inertia: 5 submissions: 2 graded, 1 with compile errors, 1 rejected, "
                         "1 not graded for a fault of the framework"));
    CHECK(contains(text, "        passed failed   stub  not defined  compile error  not run\n"));
    CHECK(contains(text, "A2.1    mass                                  2      0      0            "
                         "0              1"));
    CHECK(contains(text, "A2.2    turn                                  1      0      1            "
                         "0              1"));
    CHECK(contains(text, "out of 5: lowest 0, median 2, mean 2.333, highest 5"));
    CHECK(!contains(text, "\nfailed:\n"));
    CHECK(contains(text, "\n0 points:\n  zed (compile error)\n"));
    CHECK(contains(text, "  mallory: rejected: expected inertia.cpp, found no file\n"));
    CHECK(contains(text, "  eve: internal_error: the test program died\n"));
    CHECK(contains(text, "  zed: compile_error\n"));
    CHECK(!contains(text, " \n"));
}

TEST_CASE("gradebook: the summary lists students by what Canvas and Moodle call them", "[report]")
{
    std::vector<Row> rows;
    for (const char* name : {"Doe, Jane_17_assignsubmission_file", "doejohn_LATE_4711_99_a2.zip",
                             "doejohn_4712_98_a2.zip", "eve"})
        rows.push_back(row_of(name, "graded", 0, 3));
    const std::string text = class_summary(rows);
    CAPTURE(text);
    CHECK(contains(text, "failed:\n  A2.1    \"Doe, Jane_17\", doejohn_4711, doejohn_4712, eve\n"));
}

TEST_CASE("gradebook: no name in the summary looks like the name of another student", "[report]")
{
    Row zed = row_of("zed (compile error), alice", "graded", 0, 0);
    Row carol = row_of("carol: graded, 5/5; alice", "rejected", 0, 0);
    carol.message = "expected inertia.cpp, found no file";
    const std::string text = class_summary({row_of("alice", "graded", 2, 3), carol, zed});
    CAPTURE(text);
    CHECK(contains(text, "\n0 points:\n  \"zed (compile error), alice\" (failed: 1, stub: 1)\n"));
    CHECK(contains(text, "  A2.1    \"zed (compile error), alice\"\n"));
    CHECK(contains(text, "  \"carol: graded, 5/5; alice\": rejected: expected inertia.cpp"));
}

TEST_CASE("gradebook: who has not defined a function is named too", "[report]")
{
    Row row = row_of("alice", "graded", 0, 3);
    row.tasks[0].status = "compile_error";
    const std::string text = class_summary({row, row_of("bob", "graded", 2, 3)});
    CAPTURE(text);
    CHECK(contains(text, "failed:\n  A2.1    alice (not defined)\n"));
}

TEST_CASE("gradebook: lines of names begin below each other", "[report]")
{
    std::vector<Row> rows;
    for (int i = 100; i < 140; ++i)
        rows.push_back(row_of("student" + std::to_string(i), "graded", 0, 0));
    const std::string text = class_summary(rows);
    CAPTURE(text);
    std::istringstream lines(text);
    int of_points = 0, of_task = 0;
    for (std::string line; std::getline(lines, line);) {
        CHECK(line.size() <= 100);
        if (line.starts_with("  student")) ++of_points;
        if (line.starts_with("  A2.1    student") || line.starts_with("          student"))
            ++of_task;
    }
    CHECK(of_points == 14); // three names in a line below "0 points:", each with its reasons
    CHECK(of_task == 6);    // seven names in a line beside the task
}

TEST_CASE("gradebook: the summary lists everybody, in lines of 100 columns", "[report]")
{
    std::vector<Row> rows;
    for (int i = 0; i < 60; ++i)
        rows.push_back(row_of("student" + std::to_string(i), "graded", 0, 3));
    const std::string text = class_summary(rows);
    std::istringstream lines(text);
    int names = 0;
    for (std::string line; std::getline(lines, line);) {
        CHECK(line.size() <= 100);
        for (std::size_t at = 0; (at = line.find("student", at)) != std::string::npos; ++at)
            ++names;
    }
    CAPTURE(text);
    CHECK(names == 60);
}

TEST_CASE("gradebook: the summary names the mistakes of several submissions", "[report]")
{
    std::vector<Row> rows = {row_of("a", "graded", 0, 0), row_of("b", "graded", 0, 0),
                             row_of("c", "graded", 0, 0)};
    rows[0].tasks[0].mistake = rows[2].tasks[0].mistake = "Twice the right one.";
    rows[1].tasks[0].mistake = "The transpose is missing.";
    const std::string text = class_summary(rows);
    CAPTURE(text);
    CHECK(contains(text, "mistakes of several submissions, as their reports name them:\n"
                         "     2  A2.1 Twice the right one.\n"));
    CHECK(!contains(text, "transpose"));
    CHECK(!contains(class_summary(some_class()), "mistakes"));
}

TEST_CASE("gradebook: a class that could not be graded has a summary too", "[report]")
{
    CHECK(contains(class_summary({row_of("a", "rejected", 0, 0)}), "1 submission: 1 rejected"));
    CHECK(class_summary({}) == "no submissions\n");
}

} // namespace rigor::testing
