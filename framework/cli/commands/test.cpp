// SPDX-License-Identifier: MIT
#include "cli/commands/test.hpp"

#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "cli/test_run.hpp"
#include "errors/input_error.hpp"
#include "grading/places.hpp"
#include "grading/process.hpp"
#include "report/terminal.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace rigor {

namespace {

struct TestOptions {
    std::vector<std::string> presets;
    bool mistakes = false, quick = false, stress = false, json = false;
    std::string out;
};

// Formula, mistake, and the test that caught it.
int list_mistakes()
{
    prepare_targets({"mistakes"});
    Command command;
    command.arguments = {places().program("check_mistakes").string()};
    const Ended ended = run(command, [](std::string_view line) { fmt::print("{}\n", line); });
    if (ended.signal || ended.status > 1)
        throw std::runtime_error("check_mistakes did not end as it should");
    return ended.status == 0 ? exit_done : exit_wrong;
}

// Every case that breaks engines, on ours, with its limits.
int stress(const TestOptions& options)
{
    if (!places().has_reference())
        throw InputError("the stress suite runs the reference's formulas, which this tree lacks");
    prepare_targets({"stress_tests"});
    Command command;
    command.arguments = {places().program("stress_tests").string()};
    if (options.quick) command.arguments.emplace_back("--quick");
    if (options.json) command.arguments.emplace_back("--json");
    if (!options.out.empty())
        command.arguments.insert(command.arguments.end(), {"--out", options.out});
    const Ended ended = run(command, [](std::string_view line) {
        fmt::print("{}\n", line);
        std::fflush(stdout);
    });
    if (ended.signal || ended.status > 2)
        throw std::runtime_error("stress_tests did not end as it should");
    return ended.status;
}

constexpr std::string_view known_presets[] = {"release", "debug", "clang"};

int test(const TestOptions& options)
{
    if (options.mistakes) return list_mistakes();
    if (options.stress) return stress(options);
    if (options.json || !options.out.empty()) throw InputError("--json and --out go with --stress");
    std::vector<std::string> presets = options.presets;
    for (const std::string& preset : presets)
        if (std::find(std::begin(known_presets), std::end(known_presets), preset) ==
            std::end(known_presets))
            throw InputError(fmt::format("expected a build, one of {}, found '{}'",
                                         fmt::join(known_presets, ", "), preset));
    if (presets.empty()) presets = {"release", "clang"};
    if (options.quick) presets = {"release"};

    const bool color = wants_color(STDOUT_FILENO);
    std::vector<SuiteResult> results = {check_format()};
    const auto run = [&](const std::string& preset) {
        const std::vector<SuiteResult> of_preset = run_preset(preset);
        results.insert(results.end(), of_preset.begin(), of_preset.end());
        return of_preset.front().verdict;
    };
    for (const std::string& preset : presets)
        if (run(preset) == SuiteResult::skipped && options.presets.empty())
            run("debug"); // the same sanitizers, by the compiler that is there
    fmt::print("\n");
    const auto count = [&](SuiteResult::Verdict verdict) {
        return std::count_if(results.begin(), results.end(),
                             [&](const SuiteResult& r) { return r.verdict == verdict; });
    };
    const auto failed = count(SuiteResult::failed), skipped = count(SuiteResult::skipped);
    for (const SuiteResult& result : results)
        if (result.verdict == SuiteResult::failed)
            fmt::print("{} {}\n", colored("failed", Color::red, color), result.name);
    fmt::print("{} passed, {} failed, {} skipped\n", count(SuiteResult::passed), failed, skipped);
    return failed == 0 ? exit_done : exit_wrong;
}

} // namespace

Action declare_test(Options& options)
{
    const auto chosen = std::make_shared<TestOptions>();
    options.words("PRESET", chosen->presets,
                  "Builds to test: release, clang (with address and undefined-behaviour "
                  "sanitizers), debug (the same by the default compiler); without one, the first "
                  "two, and debug where clang is not installed");
    options.flag("--quick", chosen->quick,
                 "The release build only; with --stress, the short cases");
    options.flag("--mistakes", chosen->mistakes,
                 "Print each plausible mistake and the test that caught it");
    options.flag("--stress", chosen->stress,
                 "Run the stress suite: what breaks engines, each case with its limits");
    options.flag("--json", chosen->json, "With --stress: print JSON");
    options.option("--out", "FILE", chosen->out, "With --stress: also write the JSON here");
    options.examples({"test            all that must hold",
                      "test --quick    the same, without sanitizers and clang", "test --mistakes",
                      "test --stress   what breaks simulators, case by case"});
    return [chosen] { return test(*chosen); };
}

} // namespace rigor
