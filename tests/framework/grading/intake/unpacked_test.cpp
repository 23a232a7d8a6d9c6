// SPDX-License-Identifier: MIT
// Tests of what the program `unpack` prints, and of the reader, which checks all of it.
#include "grading/intake/unpacked.hpp"

#include "grading/intake/refused.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "written_archive.hpp"

#include <sys/stat.h>

namespace rigor::testing::unpacked_test {

namespace {

Contents some_contents()
{
    Contents contents{IntakeLimits()};
    contents.add_source(contents.add_name("a/b.cpp"), "int x;\n\0 12 3\n");
    contents.add_source(contents.add_name("empty.hpp"), "");
    contents.add_other(contents.add_name("e 1 2"));
    return contents;
}

// Why a list of files is refused; empty if it is taken.
std::string refusal_of(const std::string& text, const IntakeLimits& limits = {})
{
    try {
        read_printed(text, limits);
        return "";
    } catch (const Refused& refused) {
        return refused.what();
    }
}

} // namespace

TEST_CASE("unpacked: contents come back as they were printed", "[intake]")
{
    const Contents before = some_contents(), after = read_printed(printed(before), {});
    REQUIRE(after.sources() == before.sources());
    REQUIRE(after.others() == before.others());
    REQUIRE(refusal_of(printed_refusal("it is empty")) == "it is empty");
}

TEST_CASE("unpacked: a list that is cut or changed is refused", "[intake]")
{
    const std::string whole = printed(some_contents());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CAPTURE(size);
        REQUIRE_FALSE(refusal_of(whole.substr(0, size)).empty());
    }
    CHECK_FALSE(refusal_of(whole + "x").empty());
    CHECK_FALSE(refusal_of("s 18446744073709551615 18446744073709551615\n").empty());
    CHECK_FALSE(refusal_of("s 5 3\n../xxabce 0 0\n").empty());
    CHECK_FALSE(refusal_of("x 1 0\nae 0 0\n").empty());
}

TEST_CASE("unpacked: the limits hold for the reader too", "[intake]")
{
    IntakeLimits limits;
    limits.entries = 2;
    CHECK(refusal_of(printed(some_contents()), limits).find("at most 2 files") !=
          std::string::npos);
    limits.bytes_at_any_ratio = 7;
    const IntakeLimits same = limits_of(arguments_of(limits));
    CHECK(same.entries == 2);
    CHECK(same.bytes_at_any_ratio == 7);
    CHECK(same.source_bytes == limits.source_bytes);
}

TEST_CASE("unpacked: a pipe in place of an archive keeps nobody waiting", "[intake]")
{
    const TemporaryFolder folder;
    REQUIRE(mkfifo((folder.path() / "a.zip").c_str(), 0600) == 0);
    REQUIRE_THROWS_AS(read_archive_behind_walls(folder.path(), "a.zip"), Refused);
    REQUIRE_THROWS_AS(read_archive_behind_walls(folder.path(), "missing.zip"), Refused);
}

} // namespace rigor::testing::unpacked_test
