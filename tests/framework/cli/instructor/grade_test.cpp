// SPDX-License-Identifier: MIT
// `rigor grade`, run as an instructor runs it: a small class of assignment A0.
#include "framework/cli/command.hpp"
#include "framework/cli/graded_class.hpp"
#include "framework/grading/intake/written_archive.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <csignal>
#include <fstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace rigor::testing {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string source(const std::string& name)
{
    return text_in(fs::path(RIGOR_SOURCE_DIR) / name);
}

// Nine submissions, of which two are good, one has nothing, and six cannot be graded.
void write_class(const TemporaryFolder& folder)
{
    const std::string solved = source("tests/alternatives/pipeline.cpp");
    write_archive(folder.path() / "alice.zip", ArchiveFormat::zip,
                  {{"a0/pipeline.cpp", solved}, {"a0/report.pdf", "-"}});
    folder.write("=bob/pipeline.cpp", solved + "\n");
    folder.write("carol/pipeline.cpp", "// nothing\n");
    folder.write("dave/a/pipeline.cpp", solved);
    folder.write("dave/b/pipeline.cpp", solved);
    folder.write("eve.tar.gz", "this is no archive");
    // the first half of an archive, as if copying it had been broken off
    const std::string whole = text_in(folder.path() / "alice.zip");
    folder.write("frank.zip", whole.substr(0, whole.size() / 2));
    folder.write("grace/collision.cpp", source("student/collision.cpp")); // for another assignment
    folder.write("heidi/pipeline.cpp", solved);
    write_archive(folder.path() / "heidi.zip", ArchiveFormat::zip, {{"pipeline.cpp", solved}});
    folder.write("ivan/notes.txt", "no file of the topic");
}

const std::string gradebook = "submission,status,points,max,A0.1\r\n"
                              "'=bob,graded,1,1,1\r\n"
                              "alice,graded,1,1,1\r\n"
                              "carol,graded,0,1,0\r\n"
                              "dave,rejected,0,1,0\r\n"
                              "eve,rejected,0,1,0\r\n"
                              "frank,rejected,0,1,0\r\n"
                              "grace,rejected,0,1,0\r\n"
                              "heidi,rejected,0,1,0\r\n"
                              "ivan,rejected,0,1,0\r\n";

Run grade(const fs::path& submissions, const fs::path& out, const std::string& jobs)
{
    return rigor({"grade", "a0", submissions.string(), "--out", out.string(), "--jobs", jobs});
}

// Starts a run and kills it when the first result is there.
void start_and_kill(const fs::path& submissions, const fs::path& out)
{
    const std::string program = std::string(RIGOR_BINARY_DIR) + "/bin/rigor";
    const pid_t process = fork();
    if (process == 0) {
        if (!std::freopen("/dev/null", "w", stdout) || !std::freopen("/dev/null", "w", stderr))
            _exit(1);
        execl(program.c_str(), "rigor", "grade", "a0", submissions.c_str(), "--out", out.c_str(),
              "--jobs", "1", nullptr);
        _exit(1);
    }
    const auto has_result = [&] {
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(out, error))
            if (fs::exists(entry.path() / "result.json")) return true;
        return false;
    };
    for (int i = 0; i < 6000 && !has_result(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    kill(process, SIGKILL);
    int state = 0;
    waitpid(process, &state, 0);
    REQUIRE(has_result());
    REQUIRE(WIFSIGNALED(state));
}

} // namespace

TEST_CASE("grade: a class gets a gradebook that does not depend on how it was made", "[cli][class]")
{
    const TemporaryFolder submissions, results;
    write_class(submissions);
    const fs::path out = results.path() / "out", killed = results.path() / "killed";
    const Run first = grade(submissions.path(), out, "2");
    CAPTURE(first.output);
    REQUIRE(first.status == 0);
    REQUIRE(text_in(out / "gradebook.csv") == gradebook);
    CHECK(contains(first.output, "dave: rejected: expected one pipeline.cpp, found 2"));
    CHECK(contains(first.output, "eve: rejected: expected a whole .zip or .tar archive"));
    CHECK(contains(first.output, "frank: rejected: expected a whole .zip or .tar archive"));
    CHECK(
        contains(first.output, "grace: rejected: expected pipeline.cpp, found \"collision.cpp\""));
    CHECK(contains(first.output, "heidi: rejected: expected one submission of this name, found 2"));
    CHECK(contains(first.output, "ivan: rejected: expected pipeline.cpp, found \"notes.txt\""));
    CHECK(contains(text_in(out / "alice/report.txt"), "ignored: \"a0/report.pdf\""));
    const json result = json::parse(text_in(out / "alice/result.json"));
    CHECK(result["status"] == "graded");
    CHECK(result["submission"] == "alice");
    CHECK(json::parse(text_in(out / "alice/gradescope.json"))["score"] == 1);
    CHECK(contains(text_in(out / "alice/junit.xml"), "failures=\"0\""));

    start_and_kill(submissions.path(), killed);
    CHECK(!fs::exists(killed / "gradebook.csv"));
    const Run resumed = grade(submissions.path(), killed, "1");
    CAPTURE(resumed.output);
    REQUIRE(resumed.status == 0);
    CHECK(!contains(resumed.output, "9 graded now"));
    REQUIRE(text_in(killed / "gradebook.csv") == gradebook);
    CHECK(text_in(killed / "summary.txt") == text_in(out / "summary.txt"));

    const Run again = grade(submissions.path(), out, "2");
    CHECK(contains(again.output, "0 graded now, 9 as before"));
    submissions.write("carol/pipeline.cpp", source("tests/alternatives/pipeline.cpp"));
    const Run changed = grade(submissions.path(), out, "2");
    CAPTURE(changed.output);
    CHECK(contains(changed.output, "1 graded now, 8 as before"));
    CHECK(contains(changed.output, "carol: 0/1 points → 1/1 points"));
}

TEST_CASE("grade: names of people and files of any system make no difference", "[cli][class]")
{
    const TemporaryFolder folder;
    const std::string solved = source("tests/alternatives/pipeline.cpp");
    std::string of_windows; // with the line ends of Windows and a byte order mark
    for (const char c : "\xEF\xBB\xBF" + solved)
        of_windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    folder.write("class/Zoë O'Brien/pipeline.cpp", of_windows);
    write_archive(folder.path() / "class/محمد علي.zip", ArchiveFormat::zip,
                  {{"a0\\", ""}, {"a0\\pipeline.cpp", of_windows + "\r\n"}});
    write_archive(folder.path() / "class/Müller, Jörg_7_assignsubmission_file_a0.tar.gz",
                  ArchiveFormat::tar_gz,
                  {{"a0/.DS_Store", "x"},
                   {"a0/pipeline.cpp", solved + "\n"},
                   {"__MACOSX/a0/._pipeline.cpp", "x"}});
    const Run run = grade(folder.path() / "class", folder.path() / "out", "2");
    CAPTURE(run.output);
    REQUIRE(run.status == 0);
    CHECK(text_in(folder.path() / "out/gradebook.csv") ==
          "submission,status,points,max,A0.1\r\n"
          "\"Müller, Jörg_7_assignsubmission_file_a0\",graded,1,1,1\r\n"
          "Zoë O'Brien,graded,1,1,1\r\n"
          "محمد علي,graded,1,1,1\r\n");
    CHECK(contains(text_in(folder.path() / "out/moodle.csv"),
                   "Participant 7,\"Müller, Jörg\",1,1,,\r\n"));
    CHECK(contains(text_in(folder.path() / "out/محمد علي/junit.xml"), "name=\"محمد علي\""));
}

TEST_CASE("grade: a name that a file has while it is written costs its submission only",
          "[cli][class]")
{
    const TemporaryFolder folder;
    for (const char* name : {"alice", "summary.txt.new", "gradebook.csv.new", "moodle.csv"})
        folder.write("class/" + std::string(name) + "/pipeline.cpp",
                     source("tests/alternatives/pipeline.cpp"));
    const Run run = grade(folder.path() / "class", folder.path() / "out", "2");
    CAPTURE(run.output);
    REQUIRE(run.status == 0);
    CHECK(text_in(folder.path() / "out/gradebook.csv") == "submission,status,points,max,A0.1\r\n"
                                                          "alice,graded,1,1,1\r\n"
                                                          "gradebook.csv.new_,rejected,0,1,0\r\n"
                                                          "moodle.csv_,rejected,0,1,0\r\n"
                                                          "summary.txt.new_,rejected,0,1,0\r\n");
    CHECK(contains(text_in(folder.path() / "out/summary.txt"), "4 submissions: 1 graded"));
}

TEST_CASE("grade: a secret makes it worthless to know the cases", "[.long][cli][class]")
{
    const TemporaryFolder submissions, results;
    const std::string secret = submissions.write("secret", "sixteen letters or more\n").string();
    const fs::path all = submissions.path() / "class";
    submissions.write("class/alice/pipeline.cpp", source("tests/alternatives/pipeline.cpp"));
    submissions.write("class/mallory/pipeline.cpp",
                      source("tests/attacks/submissions/detection/known_cases.cpp"));
    const auto result_of = [&](const std::string& out, const std::vector<std::string>& options) {
        std::vector<std::string> arguments = {"grade", "a0", all.string(), "--out",
                                              (results.path() / out).string()};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Run run = rigor(arguments);
        CAPTURE(run.output);
        REQUIRE(run.status == 0);
        REQUIRE(contains(run.output, "a student can know them") == options.empty());
        REQUIRE(json::parse(text_in(results.path() / out / "alice/result.json"))["score"] == 1);
        return json::parse(text_in(results.path() / out / "mallory/result.json"));
    };
    const json known = result_of("known", {}), first = result_of("first", {"--secret", secret}),
               again = result_of("again", {"--secret", secret});
    CHECK(known["score"] == 1);
    CHECK(known["seeds"] == "the same for all");
    CHECK(first["score"] == 0);
    CHECK(first["seeds"] == "drawn by a secret");
    CHECK(first["tests"][0]["seed"].is_number());
    CHECK(first["tests"][0]["seed"] == again["tests"][0]["seed"]);
    const json another = result_of(
        "another", {"--secret", submissions.write("other", "seventeen other letters").string()});
    CHECK(another["tests"][0]["seed"] != first["tests"][0]["seed"]);
}

TEST_CASE("grade: bad input for the run is one line and nothing is written", "[cli][class]")
{
    const TemporaryFolder submissions, results;
    write_class(submissions);
    const std::string all = submissions.path().string(), out = (results.path() / "out").string();
    const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
        {{"grade", "a0", all}, "expected --out DIR"},
        {{"grade", "a0", "--out", out}, "expected submissions"},
        {{"grade", "A2.1", all, "--out", out}, "a part of one"},
        {{"grade", "a0", all + "/missing", "--out", out}, "found no file"},
        {{"grade", "a0", all, "--out", out, "--jobs", "1000"}, "at most 256"},
        {{"grade", "a0", all, "--out", out, "--secret", all + "/none"},
         "--secret: expected a file"},
        {{"grade", "a0", all, "--out", out, "--secret", all + "/carol/pipeline.cpp"},
         "at least 16 bytes"},
        {{"grade", "a0", all, "--out", all}, "expected an empty folder"},
        {{"grade", "a0", all, "--out", all + "/out"}, "outside of"}};
    for (const auto& [arguments, message] : wrong) {
        const Run run = rigor(arguments);
        CAPTURE(run.output);
        CHECK(run.status == 2);
        CHECK(contains(run.output, message));
        CHECK(!fs::exists(out));
    }
}

} // namespace rigor::testing
