// SPDX-License-Identifier: MIT
#include "support/in_words.hpp"

#include "support/catch.hpp"
#include "support/verdict.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>

namespace rigor::testing {

namespace {

// Ends the test case. The report says what was expected and what was found instead.
void fail(const std::string& expected, const std::string& actual)
{
    Verdict& v = verdict();
    if (v.status.empty()) { // only the first failure is reported
        v.status = "failed";
        v.expected = expected;
        v.actual = actual;
        v.error = v.tolerance = std::numeric_limits<double>::quiet_NaN(); // words have none
    }
    FAIL(fmt::format("expected: {}; found: {}", expected, actual));
}

} // namespace

void check_that(bool holds, std::string_view law)
{
    if (!holds) fail(std::string(law), "it is not so");
    SUCCEED();
}

void check_count(std::ptrdiff_t found, std::ptrdiff_t expected, std::string_view things)
{
    if (found != expected)
        fail(fmt::format("{} {}", expected, things),
             fmt::format("{} {}", found, things.substr(0, things.find_first_of(",:"))));
    SUCCEED();
}

} // namespace rigor::testing
