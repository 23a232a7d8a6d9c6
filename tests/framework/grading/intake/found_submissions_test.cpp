// SPDX-License-Identifier: MIT
#include "grading/intake/found_submissions.hpp"

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <sys/stat.h>

namespace rigor::testing {

namespace {

FoundSubmissions found_in(const std::vector<std::filesystem::path>& paths)
{
    std::vector<std::string> texts;
    for (const auto& path : paths)
        texts.push_back(path.string());
    return find_submissions(texts, "collision.cpp", {"gradebook.csv"});
}

std::vector<std::string> names_of(const FoundSubmissions& found)
{
    std::vector<std::string> names;
    for (const Submission& submission : found.submissions)
        names.push_back(submission.name + (submission.refusal.empty() ? "" : "!"));
    return names;
}

using Names = std::vector<std::string>;

} // namespace

TEST_CASE("submissions: a folder of folders and archives", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("carol.tar.gz", "");
    folder.write("alice/collision.cpp", "");
    folder.write("bob/notes.txt", "");
    folder.write(".DS_Store", "");
    folder.write("list.txt", "");
    const FoundSubmissions found = found_in({folder.path()});
    REQUIRE(names_of(found) == Names{"alice", "bob", "carol"});
    REQUIRE(found.notes.size() == 1);
    REQUIRE(found.notes[0].find("\"list.txt\"") != std::string::npos);
}

TEST_CASE("submissions: a folder with the file is one submission", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("alice/collision.cpp", "");
    folder.write("alice/old/collision.cpp", "");
    folder.write("alice/old.zip", "");
    REQUIRE(names_of(found_in({folder.path() / "alice"})) == Names{"alice"});
}

TEST_CASE("submissions: several paths are each a submission or hold many", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("alice/src/collision.cpp", "");
    folder.write("alice/include/helper.hpp", "");
    folder.write("bob.zip", "");
    folder.write("late/carol/collision.cpp", "");
    folder.write("late/dave/src/collision.cpp", "");
    REQUIRE(names_of(found_in({folder.path() / "bob.zip", folder.path() / "alice",
                               folder.path() / "late", folder.path() / "alice/"})) ==
            Names{"alice", "bob", "carol", "dave"});
}

TEST_CASE("submissions: a name twice, a link, a name that cannot be shown are refused", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("alice/collision.cpp", "");
    folder.write("alice.zip", "");
    folder.write("bo\x1b/collision.cpp", "");
    std::filesystem::create_symlink("/etc", folder.path() / "eve");
    REQUIRE(names_of(found_in({folder.path()})) == Names{"alice!", "bo\\x1b!", "eve!"});
}

TEST_CASE("submissions: a name of the results' own files costs its submission only", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("alice/collision.cpp", "");
    folder.write("gradebook.csv/collision.cpp", "");
    REQUIRE(names_of(found_in({folder.path()})) == Names{"alice", "gradebook.csv_!"});
}

TEST_CASE("submissions: a pipe is refused without being opened", "[intake]")
{
    const TemporaryFolder folder;
    REQUIRE(mkfifo((folder.path() / "alice.zip").c_str(), 0600) == 0);
    folder.write("bob/collision.cpp", "");
    REQUIRE(names_of(found_in({folder.path() / "alice.zip", folder.path() / "bob"})) ==
            Names{"alice!", "bob"});
}

TEST_CASE("submissions: what a dot hides is passed over with a note", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("alice/collision.cpp", "");
    folder.write(".bob/collision.cpp", "");
    folder.write(".carol.zip", "");
    folder.write(".DS_Store", "");
    const FoundSubmissions found = found_in({folder.path()});
    REQUIRE(names_of(found) == Names{"alice"});
    REQUIRE(found.notes.size() == 1);
    CAPTURE(found.notes[0]);
    REQUIRE(found.notes[0].find("passed over \".bob\", \".carol.zip\": ") != std::string::npos);
}

TEST_CASE("submissions: none is an error", "[intake]")
{
    const TemporaryFolder folder;
    REQUIRE_THROWS_AS(found_in({folder.path()}), InputError);
    REQUIRE_THROWS_AS(found_in({folder.path() / "missing"}), InputError);
}

} // namespace rigor::testing
