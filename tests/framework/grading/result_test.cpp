// SPDX-License-Identifier: MIT
#include "grading/result.hpp"

#include "support/catch.hpp"

namespace rigor::testing::result_test {

namespace {

// A law that holds, one that fails in a random case, and one that fails in a case by hand.
std::vector<TestCase> three_laws()
{
    std::vector<TestCase> tests(3);
    for (std::size_t i = 0; i < tests.size(); ++i)
        tests[i].name = "law " + std::to_string(i);
    tests[1].status = tests[2].status = Status::failed;
    tests[1].seed = 308122980;
    return tests;
}

std::vector<TestCase> tests_with(const std::vector<Status>& statuses)
{
    std::vector<TestCase> tests;
    for (const Status status : statuses) {
        tests.emplace_back();
        tests.back().status = status;
    }
    return tests;
}

Task task_worth(double points)
{
    Task task;
    task.points = points;
    return task;
}

} // namespace

TEST_CASE("grading: a random case in which the reference fails too costs no point", "[grading]")
{
    Task worth_two;
    worth_two.points = 2;
    std::vector<TestCase> tests = three_laws();
    TaskResult task = score_task(worth_two, tests);
    std::vector<TestCase> of_reference = tests;
    of_reference[2].status = Status::passed;

    SECTION("it counts as passed, and what else is wrong stays wrong")
    {
        CHECK(forgive_faults_of_tests(of_reference, task) == std::vector<std::string>{"law 1"});
        CHECK(task.tests[1].status == Status::passed);
        CHECK(task.score == 0);
    }
    SECTION("alone it costs nothing")
    {
        task = score_task(worth_two, {tests[0], tests[1]});
        CHECK(task.score == 0);
        CHECK(forgive_faults_of_tests(of_reference, task).size() == 1);
        CHECK(task.score == 2);
        CHECK(task.status == Status::passed);
    }
    SECTION("it costs nothing either if the task discloses nothing")
    {
        worth_two.discloses = Disclosure::nothing;
        task = score_task(worth_two, {tests[0], tests[1]});
        CHECK(forgive_faults_of_tests(of_reference, task).size() == 1);
        hide_undisclosed(task);
        CHECK(task.score == 2);
    }
    SECTION("a case by hand, and one in which the reference passes, count")
    {
        of_reference[1].status = Status::passed;
        of_reference[2].status = Status::failed;
        CHECK(forgive_faults_of_tests(of_reference, task).empty());
        CHECK(forgive_faults_of_tests({}, task).empty());
        CHECK(task.score == 0);
    }
}

TEST_CASE("scoring: points are earned whole", "[scoring]")
{
    using enum Status;
    REQUIRE(score_task(task_worth(3), tests_with({passed, passed})).score == 3);
    const TaskResult one_wrong = score_task(task_worth(3), tests_with({passed, failed, passed}));
    REQUIRE(one_wrong.score == 0);
    REQUIRE(one_wrong.max_score == 3);
    REQUIRE(one_wrong.status == failed);
}

TEST_CASE("scoring: a part is earned by its own law", "[scoring]")
{
    using enum Status;
    Task task = task_worth(6);
    task.parts = {{"a law", 2}, {"another law", 1}};
    const auto score = [&](Status first, Status second, Status third) {
        std::vector<TestCase> tests = tests_with({first, second, third});
        tests[0].name = "a law";
        tests[1].name = "another law";
        return score_task(task, tests);
    };
    CHECK(score(passed, passed, passed).score == 6);
    CHECK(score(passed, passed, failed).score == 3);
    CHECK(score(passed, failed, passed).score == 2);
    CHECK(score(failed, passed, passed).score == 1);
    CHECK(score(failed, crashed, passed).score == 0);
    CHECK(score(timed_out, passed, not_finite).score == 1);
    CHECK(score(not_implemented, not_implemented, not_implemented).score == 0);
    CHECK(score(passed, passed, failed).max_score == 6);
    task.discloses = Disclosure::nothing;
    CHECK(score(passed, passed, failed).score == 3);
}

TEST_CASE("scoring: a task without a test earns nothing and counts nothing", "[scoring]")
{
    const TaskResult result = score_task(task_worth(3), {});
    REQUIRE(result.status == Status::skipped);
    REQUIRE(result.score == 0);
    REQUIRE(result.max_score == 0);
}

TEST_CASE("scoring: a task is as bad as its worst test", "[scoring]")
{
    using enum Status;
    const std::vector<Status> from_good_to_bad = {passed,     skipped,   not_implemented, failed,
                                                  not_finite, timed_out, crashed};
    for (std::size_t bad = 1; bad < from_good_to_bad.size(); ++bad)
        for (std::size_t good = 0; good < bad; ++good) {
            const Status b = from_good_to_bad[bad], g = from_good_to_bad[good];
            REQUIRE(score_task(task_worth(1), tests_with({g, b, g})).status == b);
            REQUIRE(score_task(task_worth(1), tests_with({b, g})).first_failure()->status == b);
            REQUIRE(score_task(task_worth(1), tests_with({b, g})).score == 0);
        }
}

TEST_CASE("scoring: a failure tells no more than its task discloses", "[scoring]")
{
    Task task = task_worth(2);
    std::vector<TestCase> tests = tests_with({Status::passed, Status::failed, Status::crashed});
    for (TestCase& test : tests) {
        test.name = "topic: a law";
        test.message = test.expected = test.actual = test.error = test.hint = "42";
        test.mistake = "Twice 21.";
        test.seed = 7;
    }
    const auto told = [&] {
        TaskResult result = score_task(task, tests);
        hide_undisclosed(result);
        return result;
    };
    REQUIRE(told().tests[2].message == "42");
    REQUIRE(told().mistake() == "Twice 21.");
    task.discloses = Disclosure::law;
    const TaskResult law = told();
    REQUIRE(law.status == Status::crashed);
    REQUIRE(law.tests.size() == 3);
    REQUIRE(law.mistake() == "");
    for (const TestCase& test : law.tests) {
        REQUIRE(test.name == "topic: a law");
        REQUIRE((test.message + test.expected + test.actual + test.error + test.hint).empty());
        REQUIRE_FALSE(test.seed);
    }
    task.discloses = Disclosure::nothing;
    const TaskResult nothing = told();
    REQUIRE(nothing.status == Status::crashed);
    REQUIRE(nothing.score == 0);
    REQUIRE(nothing.tests.size() == 1);
    REQUIRE(nothing.tests[0].name.empty());
    REQUIRE(nothing.mistake() == "");
    task.discloses = Disclosure::all;
    REQUIRE(score_task(task, tests_with({Status::passed})).score == 2);
}

} // namespace rigor::testing::result_test
