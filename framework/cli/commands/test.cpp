// SPDX-License-Identifier: MIT
#include "cli/commands/test.hpp"

#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "cli/test_run.hpp"
#include "errors/input_error.hpp"
#include "grading/places.hpp"
#include "report/terminal.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

namespace rigor {

namespace {

struct TestOptions {
    std::vector<std::string> presets;
    bool all = false, mistakes = false, stress = false, quick = false, json = false;
    std::string out;
};

// Prints, for each formula, the wrong versions of it that the tests must reject, and which test
// rejected each version.
int list_mistakes()
{
    prepare_targets({"mistakes"});
    const int status = run_program({places().program("check_mistakes").string()});
    if (status > exit_wrong) throw std::runtime_error(program_failed("check_mistakes", status));
    return status;
}

// Runs the stress suite: scenes in which physics engines often fail. The values that are measured
// in each scene have limits, which this engine must keep.
int stress(const TestOptions& options)
{
    if (!places().has_reference())
        throw InputError("the stress suite runs the reference's formulas, which this tree lacks");
    prepare_targets({"stress_tests"});
    std::vector<std::string> arguments = {places().program("stress_tests").string()};
    if (options.quick) arguments.emplace_back("--quick");
    if (options.json) arguments.emplace_back("--json");
    if (!options.out.empty()) arguments.insert(arguments.end(), {"--out", options.out});
    const int status = run_program(arguments);
    if (status > exit_input) throw std::runtime_error(program_failed("stress_tests", status));
    return status;
}

constexpr std::string_view known_presets[] = {"release", "debug", "clang"};

// @throws InputError for options that cannot be combined and for an unknown build
void check_usage(const TestOptions& options)
{
    const bool of_suites = options.all || !options.presets.empty();
    if (options.mistakes + options.stress + of_suites > 1)
        throw InputError("expected one of --mistakes, --stress, and PRESET or --all");
    if (!options.stress && (options.quick || options.json || !options.out.empty()))
        throw InputError("--quick, --json and --out go with --stress");
    for (const std::string& preset : options.presets)
        if (std::find(std::begin(known_presets), std::end(known_presets), preset) ==
            std::end(known_presets))
            throw InputError(fmt::format("expected a build, one of {}, found '{}'",
                                         fmt::join(known_presets, ", "), preset));
}

// Checks the format of the sources, then runs the test suites of each requested build: all of them
// with --all, otherwise the short ones.
std::vector<SuiteResult> run_suites(const TestOptions& options)
{
    std::vector<SuiteResult> results = {check_format()};
    const auto run = [&](const std::string& preset) {
        const std::vector<SuiteResult> suites =
            run_preset(preset, options.all ? SuiteSize::all : SuiteSize::sample);
        results.insert(results.end(), suites.begin(), suites.end());
        return suites.front().verdict;
    };
    for (const std::string& preset : options.presets)
        run(preset);
    if (!options.presets.empty()) return results;

    run("release");
    if (options.all && run("clang") == SuiteResult::skipped)
        run("debug"); // clang is not installed: the same sanitizers with the default compiler
    return results;
}

int test(const TestOptions& options)
{
    check_usage(options);
    if (!std::filesystem::is_directory(places().source / "tests/framework"))
        throw InputError("this tree has no tests of the framework; `./rigor check` checks your "
                         "solution");
    if (options.mistakes) return list_mistakes();
    if (options.stress) return stress(options);
    const std::vector<SuiteResult> results = run_suites(options);

    const bool color = wants_color(STDOUT_FILENO);
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
    if (!options.all) fmt::print("./rigor test --all runs everything that CI runs\n");
    return failed == 0 ? exit_done : exit_wrong;
}

} // namespace

Action declare_test(Options& options)
{
    const auto chosen = std::make_shared<TestOptions>();
    options.words("PRESET", chosen->presets,
                  "Builds to test: release, clang (with address and undefined-behaviour "
                  "sanitizers), debug (the same by the default compiler); without one, release, "
                  "and with --all also clang, or debug where clang is not installed");
    options.flag("--all", chosen->all,
                 "Run everything that CI runs: every mistake instead of a sample, other "
                 "solutions, sanitizers, stress");
    options.flag("--mistakes", chosen->mistakes,
                 "Print each plausible mistake and the test that caught it");
    options.flag("--stress", chosen->stress,
                 "Run the stress suite: what breaks engines, each case with its limits");
    options.flag("--quick", chosen->quick, "With --stress: run the short cases only");
    options.flag("--json", chosen->json, "With --stress: print JSON");
    options.option("--out", "FILE", chosen->out, "With --stress: also write the JSON here");
    options.examples({"test            in minutes: is this tree sound?",
                      "test --all      everything that CI runs", "test --mistakes",
                      "test --stress   what breaks simulators, case by case"});
    return [chosen] { return test(*chosen); };
}

} // namespace rigor
