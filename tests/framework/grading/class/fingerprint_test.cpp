// SPDX-License-Identifier: MIT
#include "grading/class/fingerprint.hpp"

#include "grading/intake/contents.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace rigor::testing::fingerprint_test {

TEST_CASE("fingerprint: it changes with each byte of an archive", "[class]")
{
    const TemporaryFolder folder;
    const Submission alice{"alice", folder.write("alice.zip", "PK one"), ""};
    const std::string one = fingerprint_of(alice, 1);
    REQUIRE(fingerprint_of(alice, 1) == one);
    folder.write("alice.zip", "PK two");
    REQUIRE(fingerprint_of(alice, 1) != one);
}

// Read byte by byte, each of these files would take minutes.
TEST_CASE("fingerprint: an archive that is too large costs no time", "[class]")
{
    const TemporaryFolder folder;
    folder.write("zoe.zip", "");
    folder.write("yan/yan.zip", "");
    for (const char* name : {"zoe.zip", "yan"}) {
        const Submission submission{"some", folder.path() / name, ""};
        const std::filesystem::path archive =
            is_directory(submission.path) ? submission.path / "yan.zip" : submission.path;
        resize_file(archive, IntakeLimits().archive_bytes + 1);
        const std::string small = fingerprint_of(submission, 1);
        resize_file(archive, std::uintmax_t{1} << 38); // takes no space on the disk
        REQUIRE(fingerprint_of(submission, 1) != small);
    }
}

TEST_CASE("fingerprint: it changes with each file of student/ that can be included", "[class]")
{
    const TemporaryFolder folder;
    folder.write("inertia.cpp", "#include \"own/table.inl\"\n");
    for (const char* name : {"own/table.inl", "a.inc", "a.hxx", "a.hh", "a.ipp", "a.cc", "a.h"}) {
        CAPTURE(name);
        const std::uint64_t without = hash_of_sources(folder.path(), 1);
        folder.write(name, "1");
        const std::uint64_t one = hash_of_sources(folder.path(), 1);
        folder.write(name, "2");
        CHECK(one != without);
        CHECK(hash_of_sources(folder.path(), 1) != one);
    }
    const std::uint64_t before = hash_of_sources(folder.path(), 1);
    folder.write("notes.txt", "3");
    CHECK(hash_of_sources(folder.path(), 1) == before);
}

TEST_CASE("fingerprint: it changes with each option of the compiler and the linker", "[class]")
{
    const Toolchain tools{{"/no/compiler", "-O1"}, {"/no/compiler", "-lm"}, {}, {}};
    const std::uint64_t before = hash_of_tools(tools, 1);
    CHECK(hash_of_tools(tools, 1) == before);
    Toolchain other = tools;
    other.compile[1] = "-O2";
    CHECK(hash_of_tools(other, 1) != before);
    other = tools;
    other.link.emplace_back("-static");
    CHECK(hash_of_tools(other, 1) != before);
}

TEST_CASE("fingerprint: what has changed during a run is named", "[class]")
{
    const TemporaryFolder folder;
    const Selection selection;
    GradingRun run;
    run.test_program = folder.write("tests", "1");
    run.oracle = folder.write("oracle", "1");
    const SharedParts before = shared_parts(selection, run);
    REQUIRE_NOTHROW(require_unchanged(before, selection, run));
    folder.write("tests", "2");
    CHECK_THROWS_WITH(require_unchanged(before, selection, run),
                      Catch::Contains("found changes in the tests: start again"));
    CHECK(fingerprint_of(shared_parts(selection, run)) != fingerprint_of(before));
    run.seed = 1;
    std::filesystem::remove(*run.oracle);
    CHECK_THROWS_WITH(require_unchanged(before, selection, run),
                      Catch::Contains("in the reference, the seed, the tests: "));
    folder.write("tests", "1");
    folder.write("oracle", "1");
    run.seed = 0;
    CHECK_NOTHROW(require_unchanged(before, selection, run));
}

TEST_CASE("fingerprint: it changes with each part that all results depend on", "[class]")
{
    const SharedParts parts = shared_parts(Selection(), GradingRun());
    CHECK(parts.size() == 13);
    for (const auto& [name, hash] : parts) {
        CAPTURE(name);
        SharedParts other = parts;
        ++other[name];
        CHECK(fingerprint_of(other) != fingerprint_of(parts));
    }
}

} // namespace rigor::testing::fingerprint_test
