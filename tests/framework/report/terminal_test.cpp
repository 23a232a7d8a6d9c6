// SPDX-License-Identifier: MIT
#include "report/terminal.hpp"
#include "support/catch.hpp"

namespace rigor::testing {

TEST_CASE("report: color is only where it is wanted", "[report]")
{
    REQUIRE(colored("x", Color::red, false) == "x");
    REQUIRE(colored("x", Color::red, true) == "\033[31mx\033[0m");
}

TEST_CASE("report: width counts characters and not bytes", "[report]")
{
    REQUIRE(columns("ω = I⁻¹ L") == 9);
    REQUIRE(padded("ω", 3) == "ω  ");
    REQUIRE(wrapped("one two three", 7, 2) == "one two\n  three");
    REQUIRE(wrapped("unbreakable", 4, 0) == "unbreakable");
}

} // namespace rigor::testing
