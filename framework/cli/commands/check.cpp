// SPDX-License-Identifier: MIT
#include "cli/commands/check.hpp"

#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "cli/progress.hpp"
#include "cli/secret.hpp"
#include "errors/input_error.hpp"
#include "grading/places.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"
#include "report/build_notes.hpp"
#include "report/result_json.hpp"
#include "report/table.hpp"
#include "report/terminal.hpp"
#include "report/write_whole.hpp"
#include "sandbox/tier.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace rigor {

namespace {

struct CheckOptions {
    std::vector<std::string> what;
    std::string with = "student", out, secret;
    std::uint32_t seed = 0;
    bool json = false;
};

int status_of(const std::vector<Result>& results)
{
    const auto any = [&](auto predicate) {
        return std::any_of(results.begin(), results.end(), predicate);
    };
    if (any([](const Result& r) { return r.status == SubmissionStatus::internal_error; }))
        return exit_fault;
    return any([](const Result& r) { return !r.all_points(); }) ? exit_wrong : exit_done;
}

void print_report(const std::vector<Result>& results, const Implementation& implementation)
{
    const bool color = wants_color(STDOUT_FILENO);
    for (const Result& result : results) {
        fmt::print("{}{}", &result == results.data() ? "" : "\n",
                   points_table(result, implementation, color));
        for (const std::string& note : result.notes)
            fmt::print("\n{}\n", note);
    }
    if (results.size() > 1) fmt::print("\n{}", summary(results, color));
}

// Refuses to grade an assignment whose file is missing in the graded folder: otherwise the points
// would be for the file in student/.
void require_own_file(const Selection& selection, const Implementation& implementation)
{
    const std::vector<std::string>& borrowed = implementation.borrowed;
    const Assignment& asked = selection.assignment;
    if (std::find(borrowed.begin(), borrowed.end(), asked.topic) != borrowed.end())
        throw InputError(fmt::format("{}: expected {}.cpp, which {} is about, found no such file",
                                     implementation.name, asked.topic, asked.name));
}

int check(const CheckOptions& options)
{
    const std::vector<Selection> selections =
        select_tasks(load_assignments(places().assignments()), options.what);
    if (options.with != "student" && options.with != "reference") require_hidden(places());
    const Implementation implementation = prepared_implementation(options.with);
    for (const Selection& selection : selections)
        if (!options.what.empty()) require_own_file(selection, implementation);
    fmt::print(stderr, "{}", build_notes(implementation));
    if (options.with != "student" && options.with != "reference")
        fmt::print(stderr, "walls around it: {}\n", description(usual_tier()));
    if (has_too_weak_walls())
        fmt::print(stderr, "no walls are possible here: hidden tests are left out; with "
                           "RIGOR_TIER=C they run all the same\n");
    GradingRun run = prepared_grading_run();
    run.seed = options.seed;
    run.secret = secret_in(options.secret);
    std::vector<Result> results;
    for (const Selection& selection : selections) {
        Progress progress(selection.assignment.name);
        run.on_task = [&](int begun, int tasks, const std::string& tag) {
            progress.update((begun - 1.0) / tasks,
                            tag + " " + selection.assignment.task(tag)->name());
        };
        results.push_back(grade(selection, implementation, run));
    }
    if (!options.out.empty()) write_whole(options.out, to_json(results));
    if (options.json)
        fmt::print("{}", to_json(results));
    else
        print_report(results, implementation);
    return status_of(results);
}

} // namespace

Action declare_check(Options& options)
{
    const auto chosen = std::make_shared<CheckOptions>();
    options.words("WHAT", chosen->what,
                  "Assignments (a2-inertia, A2), topics (inertia), tasks (A2.14) or formulas "
                  "(combine); without one, all");
    options.option(
        "--with", "WHO", chosen->with,
        "student (the default), reference, or a folder that holds some of the topics' files");
    options.option("--seed", "N", chosen->seed, "First seed of the random cases (0)");
    options.option("--secret", "FILE", chosen->secret,
                   "File with a secret that draws the seeds, as in `grade`");
    options.flag("--json", chosen->json,
                 "Print the result as JSON: an object for one assignment, a list for several");
    options.option("--out", "FILE", chosen->out, "Write that JSON to a file");
    options.examples({"check inertia               the topic you work on",
                      "check A2.14                 one task",
                      "check A2.14 --seed 17       the random case that a failure named",
                      "check a4 --with reference   the solution, where it is"});
    return [chosen] { return check(*chosen); };
}

} // namespace rigor
