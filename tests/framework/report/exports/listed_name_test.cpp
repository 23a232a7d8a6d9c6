// SPDX-License-Identifier: MIT
#include "report/exports/listed_name.hpp"

#include "support/catch.hpp"

namespace rigor::testing {

TEST_CASE("listed name: names of people are shown as they are", "[report]")
{
    for (const char* name :
         {"alice", "Zo\u00EB O'Brien", "Jane Doe_15", "summary.txt_", "R&D", "=x"})
        CHECK(listed_name(name) == name);
}

TEST_CASE("listed name: what looks like two names or a remark is in quotes", "[report]")
{
    CHECK(listed_name("zed, alice") == "\"zed, alice\"");
    CHECK(listed_name("alice (compile error") == "\"alice (compile error\"");
    CHECK(listed_name("zed: graded; alice") == "\"zed: graded; alice\"");
    CHECK(listed_name("a \"b\"") == "\"a \\\"b\\\"\"");
    for (const char* name : {" alice", "alice ", "alice  bob", "alice\u00A0", "alice\u2003bob", ""})
        CHECK(listed_name(name) == "\"" + std::string(name) + "\"");
    const std::string long_name(100, 'x');
    CHECK(listed_name(long_name + ",") == "\"" + long_name + ",\""); // whole, however long it is
}

} // namespace rigor::testing
