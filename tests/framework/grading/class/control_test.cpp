// SPDX-License-Identifier: MIT
#include "grading/class/control.hpp"

#include "support/catch.hpp"

namespace rigor::testing {

namespace {

Result result_of(double first, double second)
{
    Result result;
    Task task;
    task.tag = "A4.1";
    task.points = 2;
    result.tasks.push_back({task, Status::passed, first, 2, {}});
    task.tag = "A4.2";
    result.tasks.push_back({task, Status::passed, second, 2, {}});
    return result;
}

} // namespace

TEST_CASE("control: the complete one must get every point", "[class]")
{
    CHECK(fault_of_control(result_of(2, 2), true).empty());
    CHECK(fault_of_control(result_of(2, 0), true) ==
          "got 2 of 4 points; in A4.2 it got 0, expected 2");
}

TEST_CASE("control: the empty one must get none", "[class]")
{
    CHECK(fault_of_control(result_of(0, 0), false).empty());
    CHECK(fault_of_control(result_of(0, 2), false) ==
          "got 2 of 4 points; in A4.2 it got 2, expected 0");
}

TEST_CASE("control: without points to get or with another status it has failed", "[class]")
{
    Result result = result_of(0, 0);
    result.status = SubmissionStatus::internal_error;
    result.message = "the tests died";
    CHECK(fault_of_control(result, false) == "is internal_error: the tests died");
    CHECK(fault_of_control(Result(), true) == "could get no points");
    CHECK(fault_of_control(Result(), false) == "could get no points");
}

} // namespace rigor::testing
