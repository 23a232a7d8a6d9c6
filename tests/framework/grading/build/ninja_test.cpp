// SPDX-License-Identifier: MIT
#include "grading/build/ninja.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace rigor::testing {

TEST_CASE("ninja: a compiler's first errors begin at the first and are few", "[ninja]")
{
    const std::string text = first_errors(
        {"a warning", "x.cpp: In function 'f':", "x.cpp:3: error: expected ';'", "  3 | x"});
    REQUIRE(text == "x.cpp: In function 'f':\nx.cpp:3: error: expected ';'\n  3 | x\n");
    const std::string many = first_errors(std::vector<std::string>(1000, "x.cpp:3: error: no"));
    REQUIRE(std::count(many.begin(), many.end(), '\n') == 21);
    REQUIRE(first_errors({"killed"}) == "killed\n");
}

} // namespace rigor::testing
