// SPDX-License-Identifier: MIT
#include "grading/verdicts.hpp"

#include "support/catch.hpp"

namespace rigor::testing::verdicts_test {

namespace {

// The only verdict on a test case that passed with this largest error.
TestCase passed_with(const std::string& largest_error)
{
    Verdicts verdicts;
    verdicts.take(R"({"begin":"topic: a law","tag":"A2.1"})");
    verdicts.take(R"({"tag":"A2.1","name":"topic: a law","status":"passed","hidden":false,)"
                  R"("seconds":0.5)" +
                  largest_error + "}");
    REQUIRE(verdicts.fault() == "");
    REQUIRE(verdicts.of("A2.1").size() == 1);
    return verdicts.of("A2.1").front();
}

} // namespace

TEST_CASE("verdicts: a comparison whose error is no number does not pass", "[grading]")
{
    const TestCase good = passed_with(R"(,"largest_error":0.5)");
    CHECK(good.status == Status::passed);
    CHECK(good.largest_error == 0.5);
    CHECK(passed_with("").status == Status::passed);

    const TestCase lost = passed_with(R"(,"largest_error":null)"); // JSON's NaN
    CHECK(lost.status == Status::failed);
    CHECK(lost.largest_error == 0);
    CHECK(lost.message == "the error of a comparison is not a number");
}

} // namespace rigor::testing::verdicts_test
