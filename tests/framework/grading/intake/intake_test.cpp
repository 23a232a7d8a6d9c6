// SPDX-License-Identifier: MIT
#include "grading/intake/intake.hpp"

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

} // namespace rigor::testing
