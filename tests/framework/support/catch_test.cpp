// SPDX-License-Identifier: MIT
// Tests of how captured values are printed.
#include "support/catch.hpp"

#include <limits>
#include <sstream>

using namespace rigor::testing;

TEST_CASE("catch: a captured number keeps its digits however small it is", "[support]")
{
    const auto printed = [](double value) {
        std::ostringstream text;
        text << captured(value);
        return text.str();
    };
    CHECK(printed(1e-12) == "1e-12");
    CHECK(printed(-5e-324) == "-5e-324");
    CHECK(printed(0.1) == "0.1");
    CHECK(printed(-2.5) == "-2.5");
    CHECK(printed(0) == "0");
    CHECK(printed(1.7976931348623157e308) == "1.7976931348623157e+308");
    CHECK(printed(std::numeric_limits<double>::infinity()) == "inf");
}
