// SPDX-License-Identifier: MIT
#include "report/write_whole.hpp"

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <sstream>

namespace rigor::testing {

TEST_CASE("report: a file is written whole or not at all", "[report]")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "result.json";
    write_whole(file, "first");
    write_whole(file, "second");
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    REQUIRE(text.str() == "second");
    REQUIRE(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
    REQUIRE_THROWS_AS(write_whole(folder.path() / "no" / "file", "x"), InputError);
}

TEST_CASE("report: a file that is being written has the name of its draft", "[report]")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "summary.txt";
    REQUIRE(draft_of(file).filename() == "summary.txt.new");
    create_directories(draft_of(file)); // in the way of the draft, and of nothing else
    REQUIRE_THROWS_AS(write_whole(file, "x"), InputError);
    remove(draft_of(file));
    write_whole(file, "x");
    REQUIRE(exists(file));
}

} // namespace rigor::testing
