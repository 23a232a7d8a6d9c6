// SPDX-License-Identifier: MIT
#include "report/csv.hpp"

#include "support/catch.hpp"

namespace rigor::testing {

TEST_CASE("csv: cells are quoted as RFC 4180 says", "[report]")
{
    CHECK(csv_line({"a", "b c", ""}) == "a,b c,\r\n");
    CHECK(csv_line({"a,b", "say \"x\"", "two\nlines"}) ==
          "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\"\r\n");
}

TEST_CASE("csv: no cell is a formula", "[report]")
{
    for (const char* cell : {"=1+1", "+1", "-1+1", "@SUM(A1)", "  =1", "-cmd"})
        CHECK(csv_line({cell}) == "'" + std::string(cell) + "\r\n");
    for (const char* cell : {"\uFF1D1+1", "\uFF0B1", "\uFF0D1", "\uFF20SUM(A1)", "\u00A0=1",
                             "\u3000\u200B@SUM(A1)", "\uFEFF=1"})
        CHECK(csv_line({cell}) == "'" + std::string(cell) + "\r\n");
    CHECK(csv_line({"Zo\u00EB\u00A0=1"}) == "Zo\u00EB\u00A0=1\r\n");
    CHECK(csv_line({"=HYPERLINK(\"x\",\"y\")"}) == "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"\r\n");
    CHECK(csv_line({"a=b", "1-2"}) == "a=b,1-2\r\n");
}

TEST_CASE("csv: no part of a cell is a formula where a spreadsheet splits it", "[report]")
{
    CHECK(csv_line({"zoe;=1+1"}) == "\"zoe;'=1+1\"\r\n");
    CHECK(csv_line({"zoe; \u2060@SUM(A1)"}) == "\"zoe;' \u2060@SUM(A1)\"\r\n");
    CHECK(csv_line({"7", "a\t-1"}) == "7,\"a\t'-1\"\r\n");
    CHECK(csv_line({"a|+1", "b\n=1"}) == "\"a|'+1\",\"b\n'=1\"\r\n");
    CHECK(csv_line({"\t=1"}) == "\"\t'=1\"\r\n");
    // The quote of the name would begin a cell after a split, and hide the sign.
    CHECK(csv_line({"7", "a;\"=1;b"}) == "7,\"a;'\"\"=1;b\"\r\n");
    CHECK(csv_line({"A1.2 failed 0/2; A1.3 failed 0/1"}) ==
          "\"A1.2 failed 0/2; A1.3 failed 0/1\"\r\n");
}

TEST_CASE("csv: a negative number is no formula", "[report]")
{
    CHECK(csv_line({"-1", "-2.5e-07", "-inf"}) == "-1,-2.5e-07,'-inf\r\n");
}

TEST_CASE("csv: numbers read back as the same number", "[report]")
{
    CHECK(csv_number(12) == "12");
    CHECK(csv_number(0.1) == "0.1");
    CHECK(csv_number(-0.0) == "0");
    CHECK(std::stod(csv_number(1.0 / 3)) == 1.0 / 3);
}

} // namespace rigor::testing
