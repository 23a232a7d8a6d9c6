// SPDX-License-Identifier: MIT
#include "errors/quotes.hpp"
#include "support/catch.hpp"

using namespace rigor;

TEST_CASE("quotes: what a terminal would obey is escaped", "[errors]")
{
    CHECK(in_quotes("μ = 0.5") == "\"μ = 0.5\"");
    CHECK(in_quotes("a\nb\"c") == "\"a\\nb\\\"c\"");
    CHECK(in_quotes("\x1b[31m") == "\"\\x1b[31m\"");
    CHECK(in_quotes("\xff") == "\"\\xff\""); // not UTF-8
}

TEST_CASE("quotes: a long text is cut off after 40 bytes", "[errors]")
{
    CHECK(in_quotes(std::string(50, 'x')) == "\"" + std::string(40, 'x') + "…\"");
}
