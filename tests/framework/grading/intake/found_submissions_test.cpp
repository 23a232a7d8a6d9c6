// SPDX-License-Identifier: MIT
#include "grading/intake/found_submissions.hpp"

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
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
    folder.write("alice/include/helper.hpp", "");
    REQUIRE(names_of(found_in({folder.path() / "alice"})) == Names{"alice"});
}

TEST_CASE("submissions: a folder that could be one or many is refused", "[intake]")
{
    const auto refusal = [](const std::vector<std::string>& beside) {
        const TemporaryFolder folder;
        folder.write("collision.cpp", "");
        for (const std::string& file : beside)
            folder.write(file, "");
        try {
            found_in({folder.path()});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    using Files = std::vector<std::string>;
    for (const Files& beside :
         {Files{"amy.zip", "bob.zip"}, Files{"amy/collision.cpp", "bob/src/collision.cpp"},
          Files{"amy.zip", "bob/collision.cpp"}, Files{"doejane_11_501_collision.cpp"},
          Files{"doejane_11_501_work.zip"}, Files{"Jane Doe_15_assignsubmission_file/a.zip"}}) {
        CAPTURE(beside.front());
        REQUIRE(refusal(beside).find("found collision.cpp beside \"") != std::string::npos);
    }
    for (const Files& beside : {Files{"backup.zip"}, Files{"old/collision.cpp"},
                                Files{"include/helper.hpp", "notes/list.txt"}})
        REQUIRE(refusal(beside).empty());
}

TEST_CASE("submissions: a student's folder may have the name of the file", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("collision.cpp/notes.txt", "");
    folder.write("amy/collision.cpp", "");
    CHECK(names_of(found_in({folder.path()})) == Names{"amy", "collision.cpp"});
    folder.write("bob/collision.cpp", "");
    CHECK(names_of(found_in({folder.path()})) == Names{"amy", "bob", "collision.cpp"});
}

TEST_CASE("submissions: several paths are each a submission or each hold many", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("alice/src/collision.cpp", "");
    folder.write("alice/include/helper.hpp", "");
    folder.write("bob.zip", "");
    folder.write("late/carol/collision.cpp", "");
    folder.write("late/dave/src/collision.cpp", "");
    folder.write("later/erin.zip", "");
    folder.write("later/frank/collision.cpp", "");
    REQUIRE(names_of(found_in({folder.path() / "bob.zip", folder.path() / "alice",
                               folder.path() / "alice/"})) == Names{"alice", "bob"});
    const FoundSubmissions classes = found_in({folder.path() / "late", folder.path() / "later"});
    REQUIRE(names_of(classes) == Names{"carol", "dave", "erin", "frank"});
    REQUIRE(classes.notes.empty());
    const FoundSubmissions mixed = found_in({folder.path() / "late", folder.path() / "bob.zip"});
    REQUIRE(names_of(mixed) == Names{"bob", "late"});
    REQUIRE(mixed.notes.size() == 1);
    REQUIRE(mixed.notes[0].starts_with("\"late\" looks like a folder of submissions and counts as "
                                       "one, since \"bob.zip\" beside it is one: "));
}

TEST_CASE("submissions: of the entries of a class none adds submissions of others", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("alice/collision.cpp", "");
    folder.write("bob/alice/collision.cpp", "");
    folder.write("bob/carol/collision.cpp", "");
    folder.write("dora/alice.zip", ""); // a folder with nothing but an archive is a submission
    folder.write("eve/alice.zip", "");
    folder.write("eve/carol.zip", "");
    folder.write("frank/collision.cpp", ""); // no error for all, as if this were the only path
    folder.write("frank/alice.zip", "");
    folder.write("frank/carol.zip", "");
    std::filesystem::create_symlink("alice", folder.path() / "gina");
    std::filesystem::create_symlink("nowhere", folder.path() / "hugo");
    std::vector<std::filesystem::path> entries;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        entries.push_back(entry.path());
    const FoundSubmissions found = found_in(entries);
    REQUIRE(names_of(found) == Names{"alice", "bob", "dora", "eve", "frank", "gina!", "hugo!"});
    REQUIRE(found.notes.size() == 2); // about bob and eve
}

TEST_CASE("submissions: an only path may be a link", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("class/alice/collision.cpp", "");
    std::filesystem::create_symlink("class", folder.path() / "a4");
    REQUIRE(names_of(found_in({folder.path() / "a4"})) == Names{"alice"});
    std::filesystem::create_symlink("nowhere", folder.path() / "a5");
    REQUIRE_THROWS_AS(found_in({folder.path() / "a5"}), InputError);
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

TEST_CASE("submissions: single files with the names of Canvas or Moodle", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("doejane_11_501_collision.cpp", "");
    folder.write("roejim_LATE_12_502_collision-2.cpp", "");
    folder.write("eve_13_503_homework.pdf", "");
    folder.write("eve_13_504_homework2.pdf", ""); // eve gets one row only
    folder.write("bob_14_505_collision.cpp", "");
    folder.write("bob_14_506_report.pdf", ""); // beside his submission
    folder.write("Jane Doe_15_assignsubmission_file_collision.cpp", "");
    folder.write("mine.cpp", "");
    const FoundSubmissions found = found_in({folder.path()});
    REQUIRE(names_of(found) == Names{"Jane Doe_15_assignsubmission_file_collision",
                                     "bob_14_505_collision", "doejane_11_501_collision",
                                     "eve_13_503_homework.pdf!", "roejim_LATE_12_502_collision-2"});
    REQUIRE(found.submissions[3].refusal ==
            "expected collision.cpp or an archive with it, found \"homework.pdf\"");
    REQUIRE(found.notes.size() == 3);
}

TEST_CASE("submissions: a student with several by Canvas or Moodle gets a note", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("doejane_11_501_a4.zip", "");
    folder.write("doejane_LATE_11_617_a4-1.zip", ""); // handed in again
    folder.write("roejim_12_502_a4.zip", "");
    folder.write("Zoë Roe_15_assignsubmission_file_a.zip", "");
    folder.write("Zoë Roe_15_assignsubmission_file_b.zip", "");
    const FoundSubmissions found = found_in({folder.path()});
    REQUIRE(found.submissions.size() == 5);
    REQUIRE(found.notes.size() == 2);
    CAPTURE(found.notes);
    REQUIRE(found.notes[0].starts_with("\"Zoë Roe_15\" has 2 submissions: "));
    REQUIRE(found.notes[1].starts_with("\"doejane_11\" has 2 submissions: \"doejane_11_501_a4.zip\""
                                       ", \"doejane_LATE_11_617_a4-1.zip\": "));
}

TEST_CASE("submissions: several names with one number of Moodle get a note", "[intake]")
{
    const TemporaryFolder folder; // Moodle finds a student by the number alone
    folder.write("Jane Doe_15_assignsubmission_file/collision.cpp", "");
    folder.write("x_15_assignsubmission_file/collision.cpp", "");
    const FoundSubmissions found = found_in({folder.path()});
    REQUIRE(found.notes.size() == 1);
    REQUIRE(found.notes[0].starts_with("\"Jane Doe_15\" has 2 submissions: "));
}

TEST_CASE("submissions: a name that a second file got gets a note", "[intake]")
{
    const TemporaryFolder folder;
    for (const char* name : {"kim.zip", "kim (1).zip", "lee (2).zip", "ann ().zip", "ann.zip"})
        folder.write(name, "");
    const FoundSubmissions found = found_in({folder.path()});
    REQUIRE(found.submissions.size() == 5);
    REQUIRE(found.notes == Names{"\"kim (1)\" may be a copy of \"kim\": both are graded"});
}

TEST_CASE("submissions: a text typed into Moodle is a row only of a student without a file",
          "[intake]")
{
    const TemporaryFolder folder;
    folder.write("Jane Doe_15_assignsubmission_file/collision.cpp", "");
    folder.write("Jane Doe_15_assignsubmission_onlinetext/onlinetext.html", "");
    folder.write("Jim Roe_16_assignsubmission_onlinetext/onlinetext.html", "");
    folder.write("Max Poe_17_assignsubmission_onlinetext_onlinetext.html", "");
    folder.write("Zoe Coe_18_assignsubmission_file_a.zip", "");
    folder.write("Zoe Coe_18_assignsubmission_onlinetext_onlinetext.html", "");
    const FoundSubmissions found = found_in({folder.path()});
    REQUIRE(names_of(found) == Names{"Jane Doe_15_assignsubmission_file",
                                     "Jim Roe_16_assignsubmission_onlinetext!",
                                     "Max Poe_17_assignsubmission_onlinetext_onlinetext.html!",
                                     "Zoe Coe_18_assignsubmission_file_a"});
    REQUIRE(found.submissions[1].refusal ==
            "expected collision.cpp or an archive with it, found a typed text");
    REQUIRE(found.notes.size() == 2);
}

TEST_CASE("submissions: names of people stay as they are", "[intake]")
{
    const TemporaryFolder folder;
    Names names = {"Conan O'Brien", "Jane \"JD\" Doe",
                   "Jörg Müller",   "J\u006f\u0308rg",
                   "R&D; $(x)",     "x, y",
                   "-rf",           "100%",
                   "محمد علي",      "李 雷",
                   "שרה כהן"};
    std::sort(names.begin(), names.end());
    for (const std::string& name : names)
        folder.write(name + "/collision.cpp", "");
    REQUIRE(names_of(found_in({folder.path()})) == names);
    // A mark that changes the direction of the text after it is refused, and so are a mark that
    // cannot be seen and a name that is too long to show.
    folder.write("eve\u202Egpj/collision.cpp", "");
    folder.write("100%\u2060/collision.cpp", "");
    folder.write(std::string(250, '\xff') + "/collision.cpp", "");
    std::size_t refused = 0, longest = 0;
    for (const Submission& submission : found_in({folder.path()}).submissions) {
        refused += submission.refusal.empty() ? 0 : 1;
        longest = std::max(longest, submission.name.size());
    }
    REQUIRE(refused == 3);
    REQUIRE(longest <= 255);
}

TEST_CASE("submissions: a single source is one", "[intake]")
{
    const TemporaryFolder folder;
    REQUIRE(names_of(found_in({folder.write("alice.cpp", "")})) == Names{"alice"});
}

TEST_CASE("submissions: none is an error", "[intake]")
{
    const TemporaryFolder folder;
    REQUIRE_THROWS_AS(found_in({folder.path()}), InputError);
    REQUIRE_THROWS_AS(found_in({folder.path() / "missing"}), InputError);
}

} // namespace rigor::testing
