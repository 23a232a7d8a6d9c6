// SPDX-License-Identifier: MIT
// How test cases become points. A shell script takes the place of the test program.
#include "grading/places.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"
#include "grading/verdicts.hpp"
#include "sandbox/tier.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <cstdlib>
#include <fmt/format.h>

namespace rigor::testing {

namespace {

Task task_worth(double points, const std::string& tag = "A2.1", bool is_hidden = false)
{
    Task task;
    task.tag = tag;
    task.formula = "f";
    task.points = points;
    task.is_hidden = is_hidden;
    return task;
}

std::string line_of(const std::string& tag, const std::string& status)
{
    return R"({"tag":")" + tag + R"(","name":"topic: a law","status":")" + status +
           R"(","message":"m","expected":"","actual":"","error":0,"tolerance":0,"class":"","seed":-1,"hidden":false,)" +
           R"("seconds":0.1})";
}

std::string begin_of(const std::string& tag)
{
    return R"({"begin":"topic: a law","tag":")" + tag + R"("})";
}

constexpr const char* end_of_all = R"({"end":true})";

std::string verdict_of(const std::string& tag, const std::string& status)
{
    return begin_of(tag) + "\n" + line_of(tag, status) + "\n";
}

// The result of a test program that writes these lines, and after them a line for the end, to the
// descriptor for verdicts, and then runs the shell commands `ending`. Without lines, it writes
// nothing.
// @param part  a part of the points of the first task; without a law there is none
// @param followed  the lines if the reference answers in place of the other formulas
// @param judged  the lines if the reference answers in place of the submission
Result graded(const std::string& lines, const std::string& ending, bool oracle = false,
              const PartOfPoints& part = {}, const std::string& followed = "",
              const std::string& judged = "", const Implementation& implementation = {})
{
    const TemporaryFolder folder;
    const std::string end = std::string(end_of_all) + "\n", all = lines.empty() ? "" : lines + end;
    folder.write("lines", all);
    folder.write("followed", followed.empty() ? all : followed + end);
    folder.write("judged", judged.empty() ? all : judged + end);
    const auto script =
        folder.write("tests", "#!/bin/sh\ncd " + folder.path().string() +
                                  "\ncase \"$*\" in *--others*) cat followed >&3; exit;;"
                                  " *\"--worker oracle\"*) cat judged >&3; exit;; esac\n"
                                  "cat lines >&3\n" +
                                  ending + "\n");
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    Selection selection;
    selection.assignment.name = "a2-inertia";
    selection.assignment.tasks = {task_worth(2, "A2.1"), task_worth(3, "A2.2"),
                                  task_worth(5, "A2.3", true)};
    if (!part.law.empty()) selection.assignment.tasks[0].parts = {part};
    selection.tags = {"A2.1", "A2.2", "A2.3"};
    GradingRun run;
    run.test_program = script;
    run.silence = 1;
    if (oracle) run.oracle = "oracle";
    return grade(selection, implementation, run);
}

} // namespace

TEST_CASE("scoring: a task keeps the better of two results", "[scoring]")
{
    const std::string first = verdict_of("A2.1", "not_implemented") + verdict_of("A2.2", "failed") +
                              verdict_of("A2.3", "passed");
    const Result better =
        graded(first, "", true, {}, verdict_of("A2.1", "passed") + verdict_of("A2.2", "crashed"));
    REQUIRE(better.score() == 7);
    REQUIRE(better.tasks[0].follow_through);
    REQUIRE(better.tasks[0].status == Status::passed);
    REQUIRE_FALSE(better.tasks[1].follow_through);
    REQUIRE(better.tasks[1].status == Status::failed);
    REQUIRE_FALSE(better.tasks[2].follow_through);

    const Result broken = graded(first, "", true, {}, begin_of("A2.1") + "\n");
    REQUIRE(broken.status == SubmissionStatus::graded);
    REQUIRE(broken.score() == 5);
    REQUIRE(broken.notes.size() == 1);
}

TEST_CASE("scoring: where the reference fails, the other tests keep their points", "[scoring]")
{
    const std::string first = verdict_of("A2.1", "not_implemented") + verdict_of("A2.2", "failed") +
                              verdict_of("A2.3", "passed");
    const Result result = graded(
        first, "", true, {}, verdict_of("A2.1", "internal_error") + verdict_of("A2.2", "passed"));
    REQUIRE(result.status == SubmissionStatus::graded);
    CHECK(result.score() == 8);
    CHECK(result.tasks[0].status == Status::not_implemented);
    CHECK(result.tasks[1].follow_through);
    CHECK(result.notes ==
          std::vector<std::string>{"not judged with the reference's other "
                                   "formulas: the reference failed in a test of A2.1"});
}

TEST_CASE("scoring: a late reference is blamed on nobody and the first result stays", "[scoring]")
{
    const std::string first = verdict_of("A2.1", "not_implemented") + verdict_of("A2.2", "failed") +
                              verdict_of("A2.3", "passed");
    const Result result = graded(
        first, "", true, {}, verdict_of("A2.1", "reference_late") + verdict_of("A2.2", "passed"));
    REQUIRE(result.status == SubmissionStatus::graded);
    CHECK(result.score() == 8);
    CHECK(result.tasks[0].status == Status::not_implemented);
    CHECK(result.notes.empty());
}

TEST_CASE("scoring: what did not return is not followed through", "[scoring]")
{
    const auto with_cost = [](std::string line) {
        return line.insert(line.rfind('}'), R"(,"spent":"9.5 0 A2.1","cost":"9.5 s")");
    };
    const std::string first = verdict_of("A2.1", "timed_out") + verdict_of("A2.2", "timed_out") +
                              begin_of("A2.3") + "\n" + with_cost(line_of("A2.3", "passed")) + "\n";
    // The second run has no test of A2.1, whose own formula is not asked again.
    const Result result = graded(first, "", true, {}, verdict_of("A2.2", "passed"));
    REQUIRE(result.status == SubmissionStatus::graded);
    REQUIRE_FALSE(result.tasks[0].follow_through);
    REQUIRE(result.tasks[1].follow_through);
    REQUIRE(result.notes == std::vector<std::string>{"the time budget: 9.5 s"});
}

TEST_CASE("scoring: after a test that computes without end the others run", "[scoring]")
{
    std::string stalled = line_of("A2.1", "timed_out");
    stalled.insert(stalled.rfind('}'), R"(,"spent":"1 2 A2.2","stalled":true)");
    const auto say = [](const std::string& line) { return "echo '" + line + "' >&3; "; };
    const std::string first = say(begin_of("A2.1")) + say(stalled),
                      second = say(begin_of("A2.2")) + say(line_of("A2.2", "passed"));
    // The second program runs the tests that are left, with a shorter limit for computing without
    // end (--stall), and knows what the first one has cost (--spent).
    const auto with = [&](const std::string& rest) {
        return graded("", "case \"$*\" in *'--spent 1 2 A2.2'*'--stall 2'*'[A2.1]'*'~\"topic: a "
                          "law\" [A2.2]'*) " +
                              rest + ";; *) " + first + ";; esac; exit 75");
    };
    const Result result = with(second + say(end_of_all));
    CAPTURE(result.message);
    REQUIRE(result.status == SubmissionStatus::graded);
    CHECK(result.tasks[0].status == Status::timed_out);
    CHECK(result.tasks[1].status == Status::passed);

    const Result cut_short = with(second);
    CHECK(cut_short.status == SubmissionStatus::internal_error);
    CHECK(cut_short.message == "the test program ended before all tests had run");

    const Result again = with(first);
    CHECK(again.status == SubmissionStatus::internal_error);
    CHECK(again.message == "the test case 'topic: a law' ran again");
}

TEST_CASE("scoring: points without walls around the submission are doubtful", "[scoring]")
{
    const std::string lines = verdict_of("A2.1", "passed") + verdict_of("A2.2", "passed");
    const bool has_no_walls = graded(lines, "").walls.ends_with("for a sanitizer");
    if (has_no_walls || !places().has_reference()) return; // no walls here, or no reference
    const char* before = std::getenv("RIGOR_TIER");
    const std::string tier = before ? before : "";
    setenv("RIGOR_TIER", "C", 1);
    const Result result = graded(lines, "");
    before ? setenv("RIGOR_TIER", tier.c_str(), 1) : unsetenv("RIGOR_TIER");
    REQUIRE(result.notes.size() == 1);
    CHECK(result.notes[0].starts_with("no walls were around the submission"));
    if (tier.empty() && usual_tier() != Tier::c) CHECK(graded(lines, "").notes.empty());
}

TEST_CASE("scoring: points for a law that no test has are a fault of ours", "[scoring]")
{
    const std::string lines = verdict_of("A2.1", "passed") + verdict_of("A2.2", "passed");
    CHECK(graded(lines, "", false, {"topic: a law", 1}).status == SubmissionStatus::graded);
    const Result result = graded(lines, "", false, {"topic: a low", 1});
    CHECK(result.status == SubmissionStatus::internal_error);
    CHECK(result.message == "task A2.1 has points for a law that no test has: \"topic: a low\"");
}

TEST_CASE("scoring: what the test program says is the score", "[scoring]")
{
    const Result result = graded(verdict_of("A2.1", "passed") + verdict_of("A2.2", "failed") +
                                     verdict_of("A2.1", "passed") + verdict_of("A2.3", "passed"),
                                 "exit 1", true);
    REQUIRE(result.message == "");
    REQUIRE(result.status == SubmissionStatus::graded);
    REQUIRE(result.score() == 7);
    REQUIRE(result.max_score() == 10);
    REQUIRE_FALSE(result.all_points());
}

TEST_CASE("scoring: names that are defined nowhere are noted, and a flood of them is counted",
          "[scoring]")
{
    Implementation eve;
    eve.name = "eve";
    eve.undefined = {"lost(double)"};
    const auto noted = [&] { return graded("", "", false, {}, "", "", eve).notes; };
    CHECK(noted().back() == "eve calls lost(double), which is defined nowhere");
    for (int i = 0; i < 999; ++i)
        eve.undefined.push_back(fmt::format("A1.1 formula_{} 1/1{}", i, std::string(10'000, 'x')));
    std::size_t size = 0;
    for (const std::string& note : noted())
        size += note.size();
    CHECK(size < 10'000);
    CHECK(noted().back() == "eve calls 980 more names that are defined nowhere");
}

TEST_CASE("scoring: hidden tasks count only where the reference is", "[scoring]")
{
    const Result result =
        graded(verdict_of("A2.1", "passed") + verdict_of("A2.2", "passed"), "exit 0");
    REQUIRE(result.status == SubmissionStatus::graded);
    REQUIRE(result.tasks[2].status == Status::skipped);
    REQUIRE(result.max_score() == 5);
    REQUIRE(result.all_points());
}

TEST_CASE("scoring: a fault of the tests is nobody's zero", "[scoring]")
{
    const std::string good = verdict_of("A2.1", "passed") + verdict_of("A2.2", "passed");
    const auto is_fault = [](const Result& result, const std::string& words) {
        CAPTURE(result.message, words);
        REQUIRE(result.status == SubmissionStatus::internal_error);
        REQUIRE(result.message.find(words) != std::string::npos);
        REQUIRE_FALSE(result.all_points());
        REQUIRE(result.score() == 0);
        for (const TaskResult& task : result.tasks) {
            REQUIRE(task.status == Status::skipped);
            REQUIRE(task.tests.empty());
        }
    };
    is_fault(graded("", "exit 0"), "no test of A2.1 ran");
    is_fault(graded(verdict_of("A2.1", "passed"), "exit 0"), "no test of A2.2 ran");
    is_fault(graded(good + begin_of("A2.2") + "\n", "kill -9 $$"), "died of signal 9");
    is_fault(graded(good, "kill -11 $$"), "died of signal 11");
    is_fault(graded(good + begin_of("A2.2") + "\n", "exit 3"), "gave up in 'topic: a law'");
    is_fault(graded(good + "{\n", "exit 0"), "not a verdict");
    is_fault(graded(verdict_of("A2.1", "splendid"), "exit 0"), "is no status");
    is_fault(graded(good, "exec sleep 60"), "hung");
    is_fault(graded(good, "echo no such worker >&2; exit 2", true),
             "its last words: no such worker");
}

TEST_CASE("scoring: code that does not compile has the points of nothing", "[scoring]")
{
    Selection selection;
    selection.assignment.tasks = {task_worth(2, "A2.1"), task_worth(5, "A2.3", true)};
    selection.tags = {"A2.1", "A2.3"};
    Implementation broken;
    selection.assignment.topic = "inertia";
    broken.broken["inertia"] = "inertia.cpp:3: error: expected ';'";
    const Result result = grade(selection, broken, {});
    REQUIRE(result.status == SubmissionStatus::compile_error);
    REQUIRE(result.score() == 0);
    REQUIRE(result.max_score() == 2);
    REQUIRE_FALSE(result.all_points());
}

TEST_CASE("scoring: a verdict keeps numbers and seed and says each line once", "[scoring]")
{
    Verdicts verdicts;
    verdicts.take(begin_of("A2.1"));
    REQUIRE(verdicts.open() == "topic: a law");
    verdicts.take(
        R"({"tag":"A2.1","name":"topic: a law","status":"failed","message":"a\nseed := 7\na\nb",)"
        R"("expected":"1","actual":"2","error":1.0,"tolerance":1e-15,"class":"R","place":"","seed":7,)"
        R"("mistake":"Twice the right one.","hidden":true,"seconds":0.5})");
    REQUIRE(verdicts.fault() == "");
    REQUIRE(verdicts.open() == "");
    const TestCase& test = verdicts.of("A2.1").at(0);
    REQUIRE(test.message == "a\nb");
    REQUIRE(test.mistake == "Twice the right one.");
    REQUIRE(test.seed == 7);
    REQUIRE(test.error == "1");
    REQUIRE(test.tolerance == "1e-15");
    REQUIRE(test.is_hidden);
    REQUIRE(verdicts.of("A2.2").empty());
}

namespace {

std::string failed_at_seed(const std::string& tag)
{
    std::string line = verdict_of(tag, "failed");
    return line.replace(line.find("\"seed\":-1"), 9, "\"seed\":17");
}

} // namespace

TEST_CASE("grading: what fails at random is judged once more with the reference", "[grading]")
{
    const std::string lines =
        failed_at_seed("A2.1") + verdict_of("A2.2", "failed") + verdict_of("A2.3", "passed");
    // The test program writes the same lines for every worker, so also for the reference.
    const Result result = graded(lines, "", true);
    CHECK(result.tasks[0].score == 2);
    CHECK(result.tasks[1].score == 0); // a case by hand
    REQUIRE(result.notes.size() == 1);
    CHECK(result.notes[0] == "A2.1: 'topic: a law' does not count, since the reference fails in "
                             "the same random case");
}

TEST_CASE("grading: a reference that is late or fails itself forgives nothing", "[grading]")
{
    const std::string lines =
        failed_at_seed("A2.1") + verdict_of("A2.2", "passed") + verdict_of("A2.3", "passed");
    for (const char* status : {"reference_late", "internal_error"}) {
        CAPTURE(status);
        const Result result = graded(lines, "", true, {}, "", verdict_of("A2.1", status));
        CHECK(result.status == SubmissionStatus::graded);
        CHECK(result.tasks[0].score == 0);
        CHECK(result.score() == 8);
        CHECK(result.notes.empty());
    }
}

} // namespace rigor::testing
