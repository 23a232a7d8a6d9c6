// SPDX-License-Identifier: MIT
#include "cli/commands/compare.hpp"

#include "cli/difference.hpp"
#include "cli/draw.hpp"
#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "cli/progress.hpp"
#include "cli/scene_run.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace rigor {

namespace {

struct CompareOptions {
    std::string scene, with = "student", out;
    DrawOptions draw;
};

// The trajectory of an implementation's run, with every step recorded.
Trajectory every_step(const Implementation& implementation, const Scene& scene, RunOutcome& outcome)
{
    Trajectory result;
    Progress progress(implementation.name);
    SceneRun run;
    run.record = Record::every_step;
    run.on_start = [&](const Scene& started, const std::vector<RecordedBody>& bodies) {
        result.scene = started;
        result.bodies = bodies;
    };
    run.on_frame = [&](const Frame& frame) {
        result.frames.push_back(frame);
        progress.update(frame.time / scene.end,
                        fmt::format("{:.2f} s of {:g} s", frame.time, scene.end));
    };
    outcome = run_in_worker(implementation, scene, run);
    return result;
}

constexpr std::size_t most_shown = 8;

void print(const std::vector<Difference>& differences)
{
    for (std::size_t i = 0; i < differences.size() && i < most_shown; ++i) {
        const Difference& d = differences[i];
        fmt::print("  {}: {}\n    expected   {}\n    actual     {}\n    difference {:.3g}, same "
                   "within {:.3g}\n",
                   d.body, d.quantity, d.expected, d.actual, d.size, d.allowed);
    }
    if (differences.size() > most_shown)
        fmt::print("  and {} more\n", differences.size() - most_shown);
}

// Prints how the differences grow: the largest difference of each quantity at equal intervals from
// the frame with index `first` on, and in the last frame, at most at 18 moments.
void print_growth(const Comparison& comparison, const Trajectory& actual, std::size_t first)
{
    std::vector<const char*> quantities;
    if (!actual.scene.bodies.empty()) quantities = {"X [m]", "q [rad]", "V [m/s]", "L [kg m²/s]"};
    if (!actual.scene.solids.empty())
        quantities.insert(quantities.end(), {"x [m]", "v [m/s]", "σ [Pa]", "ε_p"});
    fmt::print("\n  {:>8} {:>9} ", "step", "t [s]");
    for (const char* quantity : quantities)
        fmt::print(" {:>10}", quantity);
    fmt::print("\n");
    const std::size_t last = actual.frames.size() - 1,
                      stride = std::max<std::size_t>(1, (last - first) / 9);
    for (std::size_t i = first;; i = std::min(i + stride, last)) {
        std::map<std::string, double> largest;
        for (const Difference& d : comparison.frame(actual.frames[i]))
            largest[d.quantity] = std::max(largest[d.quantity], d.size);
        const bool same_mesh = largest.count("mesh, cracked otherwise") == 0;
        fmt::print("  {:>8} {:>9.4g} ", actual.frames[i].step, actual.frames[i].time);
        for (const char* quantity : quantities)
            fmt::print(" {:>10}",
                       largest.count(quantity) ? fmt::format("{:.2e}", largest[quantity]) : "same");
        fmt::print("{}\n", same_mesh ? "" : "  another mesh");
        if (i == last) return;
    }
}

// Prints the first differences between two runs. @return whether the runs agree
bool report_numbers(const Comparison& comparison, const Trajectory& actual, const std::string& name)
{
    const std::vector<Difference> bodies = comparison.bodies(actual.bodies);
    if (!bodies.empty()) {
        fmt::print("{} differs from the reference before the first step:\n", name);
        print(bodies);
    }
    for (std::size_t i = 0; i < actual.frames.size(); ++i) {
        const std::vector<Difference> differences = comparison.frame(actual.frames[i]);
        if (differences.empty()) continue;
        fmt::print("{} differs from the reference first at step {}, t = {:g} s:\n", name,
                   actual.frames[i].step, actual.frames[i].time);
        print(differences);
        print_growth(comparison, actual, i);
        return false;
    }
    return bodies.empty();
}

int compare(const CompareOptions& options)
{
    check_drawing(options.draw);
    const Scene scene = load_scene(find_scene(options.scene));
    const Implementation reference = working_implementation("reference");
    const Implementation implementation = working_implementation(options.with);
    RunOutcome expected_outcome, outcome;
    const Comparison comparison(every_step(reference, scene, expected_outcome));
    if (!expected_outcome.failure.empty())
        throw std::runtime_error("the reference: " + expected_outcome.failure);
    const Trajectory actual = every_step(implementation, scene, outcome);

    if (actual.frames.empty()) return report_outcome(outcome, implementation);
    const bool agree = report_numbers(comparison, actual, options.with);
    if (agree && actual.frames.back().step > 0)
        fmt::print("{} is the same as the reference for {} steps, to {:g}\n", options.with,
                   actual.frames.back().step, same_within);
    std::fflush(stdout);
    if (!options.out.empty())
        draw_comparison(comparison.expected(), actual, options.with, options.out, options.draw);
    const int status = report_outcome(outcome, implementation);
    return status == exit_done && !agree ? exit_wrong : status;
}

} // namespace

Action declare_compare(Options& options)
{
    const auto chosen = std::make_shared<CompareOptions>();
    options.word("SCENE", chosen->scene, "A scene file, or the name of one that ships");
    options.option("--with", "WHO", chosen->with,
                   "student (the default) or a folder, compared with the reference");
    options.option("--out", "DIR", chosen->out,
                   "Draw both in one picture a frame, the other one as a ghost");
    declare_drawing(options, chosen->draw);
    options.examples({"compare rod_tip               the first step that differs",
                      "compare rod_tip --out frames  the same, and what it looks like"});
    return [chosen] { return compare(*chosen); };
}

} // namespace rigor
