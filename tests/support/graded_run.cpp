// SPDX-License-Identifier: MIT
// Setup of the graded tests, which call the formulas of a worker. A failure of the worker becomes
// the verdict of the test case.
#include "diagnosis/workers/task_mistake.hpp"
#include "formulas/table.hpp"
#include "support/catch.hpp"
#include "support/run.hpp"
#include "support/values/call_text.hpp"
#include "support/verdict.hpp"
#include "worker/failure.hpp"
#include "worker/protocol/wire.hpp"
#include "worker/proxy/own_time.hpp"
#include "worker/proxy/proxy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace rigor::testing {

namespace {

bool follows_through = false, was_reference_late = false;
int verdicts = -1;
double longest_stall = 0; // [s] on a processor

// The longest time on a processor for a test case with all its scenes: what is left of `free_time`,
// which all test cases of this process share, but at most `longest_test` and at least
// `shortest_limit` [s]. Bodies that a wrong formula lets fall into each other keep the engine busy
// in each scene.
constexpr double longest_test = 60 * sanitizer_factor, shortest_limit = 15 * sanitizer_factor,
                 free_time = 120 * sanitizer_factor;

double longest_test_now()
{
    const double used = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    return std::clamp(free_time - used, shortest_limit, longest_test);
}

std::optional<OwnTimeLimit> limit_of_test;
bool shows_calls = false; // whether a failure of the running test case shows the last call

// The assignment of a task: "A2" of "A2.14".
std::string_view assignment_of(std::string_view tag)
{
    return tag.substr(0, tag.find('.'));
}

bool has_formula(std::string_view tag)
{
    return std::any_of(std::begin(formulas), std::end(formulas),
                       [&](const Formula& f) { return f.tag == tag; });
}

// Whether the arguments of a task's formula can be read: those of a test that a student wrote are
// all that the test has asked.
bool has_readable_calls(std::string_view tag)
{
    return has_formula(tag) && assignment_of(tag) != "A8";
}

// The formulas that a task is not about. The task of a formula is about this formula alone; a task
// about scenes is about all formulas of its assignment.
FormulaSet others_of(std::string_view tag)
{
    const bool is_one_formula = has_formula(tag);
    FormulaSet others;
    for (unsigned i = 0; i < formula_count; ++i)
        others[i] = is_one_formula ? formulas[i].tag != tag
                                   : assignment_of(formulas[i].tag) != assignment_of(tag);
    return others;
}

// Reads the text that `cost_so_far` of an earlier run gave.
Spent spent_in(const std::string& text)
{
    std::istringstream words(text);
    double calls = 0, scenes = 0, starts = 0;
    if (!(words >> calls >> scenes >> starts))
        throw std::runtime_error(
            "graded_tests: expected --spent SECONDS SECONDS SECONDS TAG…, found " + text);
    using Seconds = std::chrono::duration<double>;
    Spent spent{Seconds(calls), Seconds(scenes), Seconds(starts), {}};
    for (std::string tag; words >> tag;)
        for (unsigned i = 0; i < formula_count; ++i)
            if (formulas[i].tag == tag) spent.given_up.push_back(FormulaIndex{i});
    return spent;
}

} // namespace

void prepare(const RunOptions& options)
{
    if (options.worker.empty())
        throw std::runtime_error("graded_tests: expected --worker FILE, the program to be tested");
    std::optional<std::filesystem::path> oracle;
    if (!options.oracle.empty()) oracle = options.oracle;
    Limits limits;
    // A sanitizer needs system calls and files that a worker must not have.
    if (!is_sanitized) limits.trust = Trust::students;
    make_undumpable();
    use_worker(options.worker, oracle, limits);
    if (!options.others.empty() && (options.others != "reference" || !oracle))
        throw std::runtime_error("graded_tests: expected --others reference with --oracle FILE");
    follows_through = !options.others.empty();
    verdicts = options.verdicts;
    longest_stall = options.stall * sanitizer_factor;
    if (!options.spent.empty()) worker().budget().go_on_from(spent_in(options.spent));
}

CostSoFar cost_so_far()
{
    const Spent spent = worker().budget().spent();
    std::string text =
        fmt::format("{} {} {}", spent.calls.count(), spent.scenes.count(), spent.starts.count());
    for (const FormulaIndex formula : spent.given_up)
        text += fmt::format(" {}", formulas[static_cast<unsigned>(formula)].tag);
    return {text, worker().budget().report()};
}

namespace {

// Lets the reference answer calls of the formulas that the task is not about. The reference has a
// time limit of its own in each test case. So if wrong answers give the reference work without end,
// only this test case suffers. The limit is shorter after the first test case that exceeded it,
// since other test cases may exceed it too.
void follow_through(const std::string& tag)
{
    constexpr double limit_once_late = 1 * sanitizer_factor; // the reference needs half of it
    replace_by_reference(others_of(tag));
    oracle()->begin_budget_again(std::chrono::duration<double>(
        was_reference_late ? std::min(limit_once_late, longest_stall) : longest_stall));
}

} // namespace

/// Starts a new worker process for each task, so that no task can affect another one, and after
/// each test case that failed.
void begin_test_case(const std::string& tag, bool goes_on, const StalledLine& stalled)
{
    if (goes_on)
        forget_calls();
    else
        renew_worker();
    limit_of_test.reset();
    limit_of_test.emplace("the test", longest_test_now());
    if (verdicts >= 0) watch_own_time({verdicts, stalled.before, stalled.after}, longest_stall);
    shows_calls = has_readable_calls(tag);
    if (follows_through) follow_through(tag);
}

namespace {

template <class Result, class... Argument>
std::string decoded(Result (*)(Argument...), std::string_view name,
                    std::span<const std::byte> encoded)
{
    wire::Reader reader(encoded);
    std::tuple<std::remove_cvref_t<Argument>...> arguments;
    std::apply([&](auto&... argument) { (wire::decode(reader, argument), ...); }, arguments);
    return call_text(name, arguments);
}

using Decode = std::string (*)(std::span<const std::byte>);

#define RIGOR_ROW(tag, topic, function, ...)                                                       \
    [](std::span<const std::byte> encoded) {                                                       \
        return decoded(&rigor::function, #function, encoded);                                      \
    },
constexpr Decode decoders[] = {RIGOR_FORMULAS(RIGOR_ROW)};
#undef RIGOR_ROW

} // namespace

std::string last_call_text()
{
    constexpr std::size_t longest = 2000; // [bytes]; a longer call would fill the report
    const FormulaCall* call = last_call();
    if (!shows_calls || !call || call->arguments.size() > longest) return "";
    return decoders[static_cast<unsigned>(call->formula)](call->arguments);
}

std::string mistake_text(const std::string& tag)
{
    return diagnosis::task_mistake(tag);
}

namespace {

std::string note(std::string_view status, const std::string& text)
{
    verdict().status = status; // replaces earlier notes: this ended the test case
    verdict().expected = verdict().actual = "";
    return text;
}

} // namespace

} // namespace rigor::testing

CATCH_TRANSLATE_EXCEPTION(const rigor::NotImplemented& stub)
{
    return rigor::testing::note("not_implemented", rigor::describe(stub));
}

CATCH_TRANSLATE_EXCEPTION(const rigor::FormulaMissing& missing)
{
    return rigor::testing::note("compile_error", missing.what());
}

CATCH_TRANSLATE_EXCEPTION(const rigor::WorkerFailure& failure)
{
    std::string text = failure.what();
    if (!failure.output.empty()) text += "\nIt printed: " + failure.output;
    return rigor::testing::note(failure.status(), text);
}

CATCH_TRANSLATE_EXCEPTION(const rigor::NotFinite& failure)
{
    return rigor::testing::note("not_finite", failure.what());
}

// A failure of the oracle is not the student's fault.
CATCH_TRANSLATE_EXCEPTION(const rigor::OracleFailure& failure)
{
    rigor::testing::was_reference_late |= failure.is_late;
    return rigor::testing::note(failure.is_late ? "reference_late" : "internal_error",
                                failure.what());
}

// Nor is it the student's fault if a worker cannot be started.
CATCH_TRANSLATE_EXCEPTION(const std::system_error& failure)
{
    return rigor::testing::note("internal_error", failure.what());
}
