// SPDX-License-Identifier: MIT
// Runs the graded tests for the selected tasks and scores them. Hidden tests run only if there is
// an oracle: a worker process that runs the reference. The test program sends each verdict at once.
// If verdicts are missing, or the program crashes or hangs, the result is an internal error, and
// its points do not count. With an oracle, tasks that lost points may be judged a second time
// (`follow_through`, `judge_again_with_reference`).
#include "grading/run_tests.hpp"

#include "errors/quotes.hpp"
#include "grading/places.hpp"
#include "grading/process.hpp"
#include "grading/verdicts.hpp"
#include "sandbox/tier.hpp"
#include "seeds/drawn_seed.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace rigor {

namespace {

// The tasks that this run can judge.
std::vector<std::string> runnable(const Selection& selection, bool has_oracle)
{
    std::vector<std::string> tags;
    for (const std::string& tag : selection.tags)
        if (has_oracle || !selection.assignment.task(tag)->is_hidden) tags.push_back(tag);
    return tags;
}

// The error message if a task has points for a law that no test checks; otherwise empty.
std::string missing_law(const Task& task, const std::vector<TestCase>& tests)
{
    if (tests.empty()) return ""; // no test of the task ran
    for (const PartOfPoints& part : task.parts)
        if (std::none_of(tests.begin(), tests.end(),
                         [&](const TestCase& test) { return test.name == part.law; }))
            return fmt::format("task {} has points for a law that no test has: {}", task.tag,
                               in_quotes(part.law));
    return "";
}

// The walls (sandbox) around the submission, in words. A sanitizer needs system calls that the
// sandbox forbids, so the sanitized build of the tests has only resource limits (rlimits).
std::string walls_in_words()
{
#ifdef RIGOR_SANITIZED
    return "C: rlimits, for a sanitizer";
#else
    return description(usual_tier());
#endif
}

// Why a submission's points prove little; empty if they can be trusted.
std::string doubt()
{
#ifndef RIGOR_SANITIZED
    if (usual_tier() == Tier::c && places().has_reference())
        return "no walls were around the submission: it could read the reference, the tests and "
               "other submissions, so its points prove little";
#endif
    return "";
}

// The argument that tells Catch2 which test cases to run: those with this tag that have no verdict
// yet, and without an oracle no hidden ones.
std::string specification(const std::string& tag, bool has_oracle, const Verdicts& before)
{
    std::string result = "[" + tag + "]" + (has_oracle ? "" : "~[hidden]");
    for (const TestCase& done : before.of(tag))
        result += "~\"" + done.name + "\"";
    return result;
}

#ifdef RIGOR_SANITIZED // 0 is no limit: a sanitizer reserves terabytes of addresses
constexpr std::size_t memory_of_tests = 0;
#else
// The most memory that the test program may use. Its engine makes meshes from the answers of a
// submission, and wrong answers can make them larger and larger. With this limit a test fails
// before the machine runs out of memory.
constexpr std::size_t memory_of_tests = std::size_t{6} << 30; // [bytes]
#endif

// Whose code runs when a task calls the formulas of other tasks: the submission or the reference.
enum class Others { submission, reference };

// The limit on the processor time of the test program between two calls of formulas [s]. It is
// shorter after the first test case that exceeded it, since other test cases may exceed it too.
double longest_stall(const Verdicts& before)
{
    return before.stalled().empty() ? 8 : 2;
}

// @param spent   the time budget that an earlier run has used, see Verdicts::spent
// @param before  the verdicts that are known; their test cases do not run again
Command test_command(const GradingRun& run, const Implementation& implementation,
                     const std::vector<std::string>& tags, Others others, const std::string& spent,
                     const Verdicts& before)
{
    Command command;
    command.arguments = {run.test_program.string(), "--worker", implementation.worker.string()};
    if (run.oracle)
        command.arguments.insert(command.arguments.end(), {"--oracle", run.oracle->string()});
    if (others == Others::reference)
        command.arguments.insert(command.arguments.end(), {"--others", "reference"});
    if (!spent.empty()) command.arguments.insert(command.arguments.end(), {"--spent", spent});
    command.arguments.insert(command.arguments.end(),
                             {"--verdicts", std::to_string(message_descriptor), "--stall",
                              fmt::format("{}", longest_stall(before)), "--seed",
                              std::to_string(run.seed)});
    for (const std::string& tag : tags) // one after the other
        command.arguments.push_back(specification(tag, run.oracle.has_value(), before));
    if (!run.secret.empty())
        command.environment = {
            std::string(seed_key_variable) + "=" +
            seed_key(run.secret, fmt::format("{} {}", implementation.digest, run.seed))};
    command.silence = run.silence;
    command.memory = memory_of_tests;
    return command;
}

// Why the result of a run cannot be trusted; empty if it can.
std::string fault_of(const Ended& ended, const Verdicts& verdicts,
                     const std::vector<std::string>& tags)
{
    if (!verdicts.fault().empty()) return verdicts.fault();
    if (ended.timed_out) return fmt::format("the test program hung in '{}'", verdicts.open());
    if (ended.signal)
        return fmt::format("the test program died of signal {} in '{}'", ended.signal,
                           verdicts.open());
    if (!verdicts.open().empty())
        return fmt::format("the test program gave up in '{}'", verdicts.open());
    for (const std::string& tag : tags)
        if (verdicts.of(tag).empty()) return fmt::format("no test of {} ran", tag);
    if (!verdicts.is_complete()) return "the test program ended before all tests had run";
    return "";
}

// Runs the test cases of these tags. If the answers of a submission make the engine compute without
// end in a test case, the test program sends the verdict on this test case and ends itself. Then a
// new test program runs the test cases that are left.
// @param spent    the time budget that an earlier run has used, see Verdicts::spent
// @param on_line  called after each line that the test program sends
Ended run_tests(
    const GradingRun& run, const Implementation& implementation,
    const std::vector<std::string>& tags, Others others, const std::string& spent,
    Verdicts& verdicts, const OnLine& on_output, const std::function<void()>& on_line = [] {})
{
    double seconds = 0;
    for (;;) {
        const std::size_t stalled = verdicts.stalled().size();
        Ended ended = rigor::run(test_command(run, implementation, tags, others,
                                              stalled == 0 ? spent : verdicts.spent(), verdicts),
                                 on_output, [&](std::string_view line) {
                                     verdicts.take(line);
                                     on_line();
                                 });
        seconds = ended.seconds += seconds;
        if (verdicts.stalled().size() == stalled || !verdicts.fault().empty()) return ended;
    }
}

constexpr const char* not_followed = "not judged with the reference's other formulas: ";

// Judges a second time the tasks that did not get all points, now with the reference in place of
// the formulas of other tasks that they call. Each task keeps the result with more points or, for
// the same points, the one that tells the student more. A task whose formula took too long is left
// out. If the reference itself fails in a test case, the test case counts as failed, and a note
// says so. There is no note if the reference was only too late: the answers of the submission may
// give it endless work, or the machine may be busy. After a failure of the reference, a task keeps
// its first result unless the second one has more points.
void follow_through(const GradingRun& run, const Implementation& implementation,
                    const Verdicts& before, Result& result)
{
    std::vector<std::string> tags;
    for (const TaskResult& task : result.tasks)
        if (!task.tests.empty() && task.score < task.max_score &&
            !before.is_given_up(task.task.tag))
            tags.push_back(task.task.tag);
    if (!run.oracle || tags.empty()) return;
    Verdicts verdicts;
    const Ended ended = run_tests(run, implementation, tags, Others::reference, before.spent(),
                                  verdicts, [](std::string_view) {});
    result.test_seconds += ended.seconds;
    if (const std::string fault = fault_of(ended, verdicts, tags); !fault.empty()) {
        result.notes.push_back(not_followed + fault);
        return;
    }
    std::set<std::string> failed; // tags only: a message could reveal a hidden test
    for (const auto& [tag, what] : verdicts.own_failures())
        if (failed.insert(tag).second && !verdicts.was_reference_late(tag))
            result.notes.push_back(not_followed + ("the reference failed in a test of " + tag));
    for (TaskResult& task : result.tasks) {
        TaskResult followed = score_task(task.task, verdicts.of(task.task.tag));
        const bool is_better = followed.score > task.score;
        // After the first run, the student knows only that a stub of another task was called. The
        // second run tells what is wrong with this task.
        const bool tells_more = followed.score == task.score && !followed.tests.empty() &&
                                task.status == Status::not_implemented &&
                                failed.count(task.task.tag) == 0;
        if (!is_better && !tells_more) continue;
        task = std::move(followed);
        task.follow_through = is_better;
    }
}

// Runs the tests of tasks that failed in a random case once more, with the same cases and the
// reference in place of the submission. A test case that the reference fails too is a fault of the
// tests: it counts as passed, and a note says so. Nothing is forgiven in a task whose tests the
// reference did not finish, since it was too late, for example on a busy machine.
void judge_again_with_reference(const GradingRun& run, const Implementation& implementation,
                                Result& result)
{
    std::vector<std::string> tags;
    for (const TaskResult& task : result.tasks)
        if (std::any_of(task.tests.begin(), task.tests.end(), failed_at_random))
            tags.push_back(task.task.tag);
    if (!run.oracle || implementation.worker == *run.oracle || tags.empty()) return;
    Implementation reference;
    reference.name = "reference";
    reference.worker = *run.oracle;
    reference.digest = implementation.digest; // so that the same random cases are drawn
    Verdicts verdicts;
    const Ended ended =
        run_tests(run, reference, tags, Others::submission, "", verdicts, [](std::string_view) {});
    result.test_seconds += ended.seconds;
    std::set<std::string> unknown; // tasks whose verdicts say nothing about the tests
    for (const auto& [tag, what] : verdicts.own_failures())
        unknown.insert(tag);
    for (TaskResult& task : result.tasks) {
        if (unknown.count(task.task.tag) > 0) continue;
        const std::vector<std::string> laws =
            forgive_faults_of_tests(verdicts.of(task.task.tag), task);
        for (const std::string& law : laws)
            result.notes.push_back(fmt::format("{}: '{}' does not count, since the reference fails "
                                               "in the same random case",
                                               task.task.tag, law));
    }
}

} // namespace

Result ungraded(const Selection& selection, const GradingRun& run, SubmissionStatus status,
                const std::string& message)
{
    Result result = ungraded(selection.assignment, selection.tags,
                             runnable(selection, run.oracle.has_value()), status, message);
    result.seed = run.seed;
    result.has_secret_seeds = !run.secret.empty();
    return result;
}

namespace {

// A call of a function that is defined nowhere ends the program like a wrong index would, so the
// report names such functions.
void note_undefined(const Implementation& implementation, Result& result)
{
    constexpr std::size_t most_names = 20, longest_name = 300; // [bytes]
    const std::vector<std::string>& names = implementation.undefined;
    const std::size_t shown = std::min(names.size(), most_names);
    for (std::size_t i = 0; i < shown; ++i)
        result.notes.push_back(fmt::format("{} calls {}{}, which is defined nowhere",
                                           implementation.name, names[i].substr(0, longest_name),
                                           names[i].size() > longest_name ? " …" : ""));
    if (names.size() > shown)
        result.notes.push_back(fmt::format("{} calls {} more names that are defined nowhere",
                                           implementation.name, names.size() - shown));
}

} // namespace

Result grade(const Selection& selection, const Implementation& implementation,
             const GradingRun& run)
{
    const bool is_broken = implementation.is_broken(selection.assignment.topic);
    Result result;
    if (is_broken)
        result = ungraded(selection, run, SubmissionStatus::compile_error,
                          implementation.broken.at(selection.assignment.topic));
    result.assignment = selection.assignment;
    result.submission = implementation.name;
    result.seed = run.seed;
    result.has_secret_seeds = !run.secret.empty();
    result.walls = walls_in_words();
    result.build_seconds = implementation.build_seconds;
    if (is_broken) return result;
    if (const std::string why = doubt(); !why.empty()) result.notes.push_back(why);
    note_undefined(implementation, result);
    const std::vector<std::string> tags = runnable(selection, run.oracle.has_value());
    Verdicts verdicts;
    std::set<std::string> begun;
    std::string last_words;
    const auto on_line = [&] {
        if (run.on_task && begun.insert(verdicts.current_tag()).second)
            run.on_task(static_cast<int>(begun.size()), static_cast<int>(tags.size()),
                        verdicts.current_tag());
    };
    const auto on_output = [&](std::string_view line) {
        if (!line.empty()) last_words = line.substr(0, 200);
    };
    std::string fault;
    if (!tags.empty()) { // otherwise all requested tasks are hidden
        const Ended ended = run_tests(run, implementation, tags, Others::submission, "", verdicts,
                                      on_output, on_line);
        result.test_seconds = ended.seconds;
        fault = fault_of(ended, verdicts, tags);
        if (fault.empty() && !verdicts.own_failures().empty())
            fault = verdicts.own_failures().front().second;
    }
    for (const std::string& tag : selection.tags) {
        const Task& task = *selection.assignment.task(tag);
        if (fault.empty()) fault = missing_law(task, verdicts.of(tag));
        result.tasks.push_back(score_task(task, verdicts.of(tag)));
    }
    if (!fault.empty()) {
        result.status = SubmissionStatus::internal_error;
        result.message = fault + (last_words.empty() ? "" : "; its last words: " + last_words);
        // The points of the tests that did run are removed, since they would look like a grade.
        result.tasks =
            ungraded(selection, run, SubmissionStatus::internal_error, result.message).tasks;
        return result;
    }
    if (!verdicts.cost().empty()) result.notes.push_back("the time budget: " + verdicts.cost());
    follow_through(run, implementation, verdicts, result);
    judge_again_with_reference(run, implementation, result);
    for (TaskResult& task : result.tasks)
        hide_undisclosed(task);
    return result;
}

GradingRun own_grading_run(const OnBuildStep& on_step)
{
    GradingRun run;
    run.test_program = places().program("graded_tests");
    std::vector<std::string> targets = {"graded_tests"};
    if (places().has_reference() && !has_too_weak_walls()) {
        run.oracle = places().program("worker_reference");
        targets.emplace_back("worker_reference");
    }
    build_targets(targets, on_step);
    return run;
}

} // namespace rigor
