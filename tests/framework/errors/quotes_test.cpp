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

TEST_CASE("quotes: a name with a character that cannot be seen shows it", "[errors]")
{
    CHECK(in_quotes("alice\u2060") == "\"alice\\xe2\\x81\\xa0\"");
}

TEST_CASE("quotes: the length of what is shown can be chosen", "[errors]")
{
    const std::string text(50, 'x');
    CHECK(in_quotes(text, text.size()) == "\"" + text + "\"");
}

TEST_CASE("quotes: no line of a text of somebody else stands without a bar", "[errors]")
{
    CHECK(behind_bars("one line") == "| one line");
    CHECK(behind_bars("no\nhint: give all\n\nend\n") == "| no\n| hint: give all\n| \n| end");
}
