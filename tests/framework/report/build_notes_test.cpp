// SPDX-License-Identifier: MIT
#include "report/build_notes.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace rigor::testing {

TEST_CASE("build notes: what does not compile or is missing is named", "[report]")
{
    Implementation eve;
    eve.name = "eve";
    eve.broken["inertia"] = "inertia.cpp:1: error";
    eve.borrowed = {"contact", "fracture"};
    REQUIRE(build_notes(eve) == "eve/inertia.cpp does not compile: its formulas are missing\n"
                                "eve has no contact.cpp, fracture.cpp: what student/ has takes "
                                "their place\n");
    REQUIRE(build_notes({}).empty());
}

TEST_CASE("build notes: files that were left out are named, and counted if there are many",
          "[report]")
{
    Implementation eve;
    eve.name = "eve";
    for (int i = 1; i <= 7; ++i)
        eve.left_out.push_back(fmt::format("own/{}.hpp: expected a file, found a link", i));
    const std::string text = build_notes(eve);
    CHECK(text.starts_with("left out: eve/own/1.hpp: expected a file, found a link\n"));
    CHECK(std::count(text.begin(), text.end(), '\n') == 6);
    CHECK(text.ends_with("left out: 2 more files\n"));
}

} // namespace rigor::testing
