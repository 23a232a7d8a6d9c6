// SPDX-License-Identifier: MIT
#include "grading/intake/intake.hpp"

#include "grading/class/fingerprint.hpp"
#include "grading/intake/refused.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "written_archive.hpp"

namespace rigor::testing {

namespace {

const std::string wanted = "collision.cpp";

Intake taken(const std::vector<std::string>& names)
{
    Contents contents{IntakeLimits()};
    for (const std::string& name : names)
        if (is_source(name))
            contents.add_source(name, "text of " + name);
        else
            contents.add_other(name);
    return take_files_for(wanted, contents);
}

std::string refusal_of(const std::vector<std::string>& names)
{
    try {
        taken(names);
        return "";
    } catch (const Refused& refused) {
        return refused.what();
    }
}

} // namespace

TEST_CASE("intake: the file and the sources beside it are taken and the rest is ignored",
          "[intake]")
{
    const Intake intake =
        taken({"alice/collision.cpp", "alice/my/helper.hpp", "other.cpp", "alice/report.pdf",
               "__MACOSX/alice/collision.cpp", "alice/._collision.cpp"});
    REQUIRE(intake.files ==
            std::map<std::string, std::string>{{"collision.cpp", "text of alice/collision.cpp"},
                                               {"my/helper.hpp", "text of alice/my/helper.hpp"}});
    REQUIRE(intake.ignored == std::vector<std::string>{"__MACOSX/alice/collision.cpp",
                                                       "alice/._collision.cpp", "other.cpp",
                                                       "alice/report.pdf"});
}

TEST_CASE("intake: two files of one topic are refused", "[intake]")
{
    REQUIRE(refusal_of({"a/collision.cpp", "b/collision.cpp"}) ==
            "expected one collision.cpp, found 2: \"a/collision.cpp\", \"b/collision.cpp\"");
}

TEST_CASE("intake: a missing file is told with what is there instead", "[intake]")
{
    REQUIRE(refusal_of({}) == "expected collision.cpp, found no file");
    REQUIRE(refusal_of({"inertia.cpp"}) == "expected collision.cpp, found \"inertia.cpp\"");
    REQUIRE(refusal_of({"a.cpp", "b.cpp", "c.cpp", "d.cpp", "e.txt", "f.txt"}) ==
            "expected collision.cpp, found \"a.cpp\", \"b.cpp\", \"c.cpp\", \"d.cpp\" and 2 more");
    REQUIRE(refusal_of({"a_collision.cpp", "collision.cpp.bak"}) != "");
}

TEST_CASE("intake: an archive in a submission is named and not opened", "[intake]")
{
    REQUIRE(
        refusal_of({"a4/solution.zip", "a4/report.pdf"}) ==
        "expected collision.cpp, found \"a4/report.pdf\", \"a4/solution.zip\": an archive in an "
        "archive, or beside other files, is not opened");
    REQUIRE(taken({"a4/collision.cpp", "a4/old.zip"}).ignored ==
            std::vector<std::string>{"a4/old.zip"});
}

TEST_CASE("intake: backslashes of Windows lead to the same files as slashes", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("alice/src\\collision.cpp", "int x;\n");
    folder.write("alice/src\\my\\helper.hpp", "int y;\n");
    for (const ArchiveFormat format : {ArchiveFormat::zip, ArchiveFormat::tar}) {
        const auto archive = write_archive(folder.path() / "a", format,
                                           {{"src\\", ""},
                                            {"src\\collision.cpp", "int x;\n"},
                                            {"src\\my\\helper.hpp", "int y;\n"}});
        for (const auto& path : {folder.path() / "alice", archive}) {
            const Intake intake = take_submission(path, wanted);
            REQUIRE(intake.files ==
                    std::map<std::string, std::string>{{"collision.cpp", "int x;\n"},
                                                       {"my/helper.hpp", "int y;\n"}});
            REQUIRE(intake.ignored.empty());
        }
    }
}

TEST_CASE("intake: what a Mac adds to an archive is ignored", "[intake]")
{
    const TemporaryFolder folder;
    const std::string fork("\x00\x05\x16\x07\x00\x02\x00\x00Mac OS X", 16);
    for (const ArchiveFormat format : {ArchiveFormat::zip, ArchiveFormat::tar_gz}) {
        const auto archive = write_archive(folder.path() / "a", format,
                                           {{"a4/", "", AE_IFDIR},
                                            {"a4/.DS_Store", fork},
                                            {"a4/._collision.cpp", fork},
                                            {"a4/collision.cpp", "int x;\n"},
                                            {"__MACOSX/", "", AE_IFDIR},
                                            {"__MACOSX/a4/._collision.cpp", fork},
                                            {"__MACOSX/._a4", fork}});
        const Intake intake = take_submission(archive, wanted);
        REQUIRE(intake.files == std::map<std::string, std::string>{{"collision.cpp", "int x;\n"}});
        REQUIRE(intake.ignored.size() == 4);
    }
}

TEST_CASE("intake: sources that cannot lie on one disk are refused", "[intake]")
{
    const std::string both = "expected a file or a folder, found both called \"a.hpp\"";
    REQUIRE(refusal_of({"collision.cpp", "a.hpp", "a.hpp/b.hpp"}) == both);
    REQUIRE(refusal_of({"collision.cpp", "a.hpp/b.hpp", "a.hpp"}) == both);
    REQUIRE(refusal_of({"collision.cpp", "a.hpp/c/b.hpp", "a.hp", "a.hpp.h"}).empty());
    const std::string longest(251, 'a');
    REQUIRE(refusal_of({"collision.cpp", longest + ".hpp"}).empty());
    REQUIRE(refusal_of({"collision.cpp", "x/" + longest + "b/y.hpp", longest + "bcdef/y.hpp"})
                .starts_with("expected names of at most 255 bytes"));
}

TEST_CASE("intake: a folder and an archive of it give the same files", "[intake]")
{
    const TemporaryFolder folder;
    folder.write("alice/src/collision.cpp", "int x;\n");
    folder.write("alice/src/helper.hpp", "int y;\n");
    folder.write("alice/notes.txt", "hello");
    folder.write("alice/.git/config", "hello");
    const auto archive = write_archive(folder.path() / "a.zip", ArchiveFormat::zip,
                                       {{"src/collision.cpp", "int x;\n"},
                                        {"src/helper.hpp", "int y;\n"},
                                        {"notes.txt", "hello"},
                                        {".git", "hello"}});
    const Intake of_folder = take_submission(folder.path() / "alice", wanted),
                 of_archive = take_submission(archive, wanted);
    REQUIRE(of_folder.files == of_archive.files);
    REQUIRE(of_folder.ignored == of_archive.ignored);
    REQUIRE(of_folder.files.size() == 2);
}

TEST_CASE("intake: an archive that lies alone in a folder is the submission", "[intake]")
{
    const TemporaryFolder folder;
    const auto student = folder.path() / "Jane Doe_17_assignsubmission_file";
    folder.write("Jane Doe_17_assignsubmission_file/.DS_Store", "");
    write_archive(student / "a4.zip", ArchiveFormat::zip, {{"a4/collision.cpp", "int x;\n"}});
    REQUIRE(take_submission(student, wanted).files ==
            std::map<std::string, std::string>{{"collision.cpp", "int x;\n"}});
    Submission submission{"Jane Doe_17", student, ""};
    const std::string before = fingerprint_of(submission, 1);
    write_archive(student / "a4.zip", ArchiveFormat::zip, {{"a4/collision.cpp", "int y;\n"}});
    REQUIRE(fingerprint_of(submission, 1) != before);

    folder.write("Jane Doe_17_assignsubmission_file/report.pdf", "");
    REQUIRE_THROWS_AS(take_submission(student, wanted), Refused);
    write_archive(folder.path() / "bob.zip", ArchiveFormat::zip, {{"inner.zip", "PK"}});
    REQUIRE_THROWS_AS(take_submission(folder.path() / "bob.zip", wanted), Refused);
}

TEST_CASE("intake: a single source is taken as the wanted file", "[intake]")
{
    const TemporaryFolder folder;
    const auto file = folder.write("doejane_11_501_collision-1.cpp", "the text");
    const Intake intake = take_submission(file, wanted);
    REQUIRE(intake.files == std::map<std::string, std::string>{{wanted, "the text"}});
    std::filesystem::resize_file(file, IntakeLimits().source_bytes + 1);
    REQUIRE_THROWS_AS(take_submission(file, wanted), Refused);
}

} // namespace rigor::testing
