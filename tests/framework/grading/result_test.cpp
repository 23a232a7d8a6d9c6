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

} // namespace rigor::testing::result_test
