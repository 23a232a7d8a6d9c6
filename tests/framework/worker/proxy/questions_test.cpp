// SPDX-License-Identifier: MIT
// What a student's test asks is checked before a formula of ours answers it.
#include "worker/proxy/questions.hpp"

#include "support/catch.hpp"

#include <limits>
#include <stdexcept>

namespace rigor {

namespace {

Judgement question(int calls_before, std::vector<double> numbers)
{
    return {0, calls_before, std::move(numbers)};
}

const Askable three_known = {3, 2};

void check(const Judgement& judgement)
{
    check_judgement("test_units", judgement, three_known);
}

} // namespace

TEST_CASE("questions: judgements and questions of a test that follows the rules pass")
{
    for (int calls = 0; calls <= 3; ++calls)
        REQUIRE_NOTHROW(check(question(calls, {1e9, -largest_question})));
    REQUIRE_NOTHROW(check(accepted()));
    REQUIRE_NOTHROW(check(rejected(12)));
    // The size of an ordinary formula follows from its arguments, that of test_units from its
    // example.
    LineCollision collide;
    REQUIRE_NOTHROW(check_judgement("test_line_collision", question(0, {1, 2, 3, 0, 1}), collide));
    REQUIRE_THROWS_AS(check_judgement("test_line_collision", question(0, {1, 2, 3}), collide),
                      std::out_of_range);
    SpringForce force;
    REQUIRE_NOTHROW(
        check_judgement("test_spring_force", question(0, {1, 2, 3, 4, 5, 6, 7, 8}), force));
    REQUIRE_NOTHROW(
        check_judgement("test_units", question(0, {1, 2}), UnknownFormula(), {3, 4}, {}, {}));
    REQUIRE_THROWS_AS(
        check_judgement("test_units", question(0, {1}), UnknownFormula(), {3, 4}, {}, {}),
        std::out_of_range);
}

TEST_CASE("questions: a question of another size is refused")
{
    REQUIRE_THROWS_WITH(check(question(0, {1})),
                        "test_units sent a question that is none: it has 1 numbers, and the "
                        "formula takes 2");
    REQUIRE_THROWS_AS(check(question(0, {1, 2, 3})), std::out_of_range);
}

TEST_CASE("questions: a question is at most one MiB long")
{
    const std::vector<double> flood(8 << 20, 1.0);
    REQUIRE_THROWS_WITH(check_judgement("test_units", question(0, flood), {0, flood.size()}),
                        "test_units sent a question that is none: it has 67108864 bytes, and at "
                        "most 1048576 are allowed");
}

TEST_CASE("questions: a question follows calls that are known")
{
    REQUIRE_THROWS_WITH(check(question(4, {1, 2})),
                        "test_units sent a question that is none: it comes after 4 calls, and 3 "
                        "are known");
    for (const int wild : {-1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()})
        REQUIRE_THROWS_AS(check(question(wild, {1, 2})), std::out_of_range);
}

TEST_CASE("questions: numbers that no formula is made for are refused")
{
    REQUIRE_THROWS_WITH(check(question(0, {1, -1e308})),
                        "test_units sent a question that is none: it has the number -1e+308, and "
                        "numbers are at most 1e+100");
    for (const double wild :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e101})
        REQUIRE_THROWS_AS(check(question(0, {wild, 0})), std::out_of_range);
}

TEST_CASE("questions: a formula is rejected in a line of a file")
{
    REQUIRE_THROWS_AS(check(rejected(-7)), std::out_of_range);
    REQUIRE_THROWS_AS(check(rejected(std::numeric_limits<int>::min())), std::out_of_range);
}

} // namespace rigor
