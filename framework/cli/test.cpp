// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "cli/test_run.hpp"
#include "grading/places.hpp"
#include "grading/process.hpp"
#include "report/terminal.hpp"
#include "scene/scene.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace rigor {

namespace {

struct TestOptions {
    std::vector<std::string> presets;
    bool mistakes = false, quick = false;
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

constexpr std::string_view known_presets[] = {"release", "debug", "clang"};

int test(const TestOptions& options)
{
    if (options.mistakes) return list_mistakes();
    std::vector<std::string> presets = options.presets;
    for (const std::string& preset : presets)
        if (std::find(std::begin(known_presets), std::end(known_presets), preset) ==
            std::end(known_presets))
            throw InputError(fmt::format("expected a build, one of {}, found '{}'",
                                         fmt::join(known_presets, ", "), preset));
    if (presets.empty()) presets.assign(std::begin(known_presets), std::end(known_presets));
    if (options.quick) presets = {"release"};

    const bool color = wants_color(STDOUT_FILENO);
    std::vector<SuiteResult> results = {check_format()};
    for (const std::string& preset : presets) {
        const std::vector<SuiteResult> of_preset = run_preset(preset);
        results.insert(results.end(), of_preset.begin(), of_preset.end());
    }
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
                  "Builds to test: release, debug (address and undefined-behaviour sanitizers), "
                  "clang; without one, all");
    options.flag("--quick", chosen->quick, "The release build only");
    options.flag("--mistakes", chosen->mistakes,
                 "Print each plausible mistake and the test that caught it");
    options.examples({"test            all that must hold",
                      "test --quick    the same, without sanitizers and clang", "test --mistakes"});
    return [chosen] { return test(*chosen); };
}

} // namespace rigor
