// SPDX-License-Identifier: MIT
#include "cli/commands/demo.hpp"

#include "cli/draw.hpp"
#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "cli/progress.hpp"
#include "errors/input_error.hpp"
#include "grading/places.hpp"
#include "grading/process.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"
#include "report/result_json.hpp"
#include "report/table.hpp"
#include "report/terminal.hpp"
#include "report/write_whole.hpp"
#include "scene/keys/scene_keys.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fmt/format.h>
#include <future>
#include <map>
#include <unistd.h>

namespace rigor {

namespace {

namespace fs = std::filesystem;

struct DemoOptions {
    std::string out = "out/demo", size = "1280x720";
};

// One scene for each assignment that has scenes, and two for collision.
constexpr const char* scenes[] = {
    "a1-kinematics/projectile_with_spin", "a2-inertia/hammer",          "a3-rotation/tennis_racket",
    "a4-collision/billiard_break",        "a4-collision/hundred_boxes", "a5-contact/leaning_tower",
    "a6-plasticity/paper_clip",           "a7-fracture/notched_plate"};

struct Graded {
    std::string assignment;
    std::vector<std::string> submissions; // "reference", "student", or a folder in tests/samples
};

// What the demo grades: the first assignment, which has no scenes, with the reference and with the
// student's files; then three submissions of another assignment. One submission is complete, one
// is half done with the usual mistakes, and one crashes in one task and hangs in another task.
std::vector<Graded> to_grade()
{
    return {{"a0-pipeline", {"reference", "student"}},
            {"a2-inertia", {"complete", "half_done", "crashing"}}};
}

// Builds the graded tests in the background while the scenes are drawn.
class GradedTests {
public:
    GradedTests()
        : run_(std::async(std::launch::async, [this] {
              return own_grading_run([this](int done, int total, const std::string&) {
                  built_ = static_cast<double>(done) / total;
              });
          }))
    {
    }

    GradingRun wait()
    {
        Progress progress("building");
        while (run_.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready)
            progress.update(built_, "graded tests");
        return run_.get();
    }

private:
    std::atomic<double> built_ = 0; // the fraction of the build steps that are done
    std::future<GradingRun> run_;
};

void render_scenes(const Implementation& reference, const fs::path& out, DrawOptions draw)
{
    draw.video = is_installed("ffmpeg");
    for (const char* name : scenes) {
        const Scene scene = load_scene(find_scene(name));
        fmt::print("{}: {}\n", name, scene.description);
        std::fflush(stdout); // the line must come before the progress bar, which is on stderr
        if (render_scene(scene, reference, (out / scene.name).string(), draw) != exit_done)
            throw std::runtime_error(std::string("the reference does not run ") + name);
        std::fflush(stdout);
    }
}

Result grade_one(const std::string& name, const fs::path& out, const Selection& selection,
                 GradingRun run)
{
    const fs::path folder = places().source / "tests/samples" / name;
    Implementation implementation =
        prepared_implementation(fs::is_directory(folder) ? folder.string() : name);
    implementation.name = name; // the report shows this name instead of the folder
    Progress progress(name);
    run.on_task = [&](int begun, int tasks, const std::string& tag) {
        progress.update((begun - 1.0) / tasks, tag);
    };
    const Result result = grade(selection, implementation, run);
    progress.clear();
    fs::create_directories(out / name);
    write_whole(out / name / "result.json", to_json({result}));
    write_whole(out / name / "report.txt", points_table(result, implementation, false));
    if (result.status == SubmissionStatus::internal_error)
        throw std::runtime_error(name + ": " + result.message);
    return result;
}

void print_points(const std::string& assignment, const std::vector<Result>& results)
{
    const bool color = wants_color(STDOUT_FILENO);
    fmt::print("\n{:<32}", assignment);
    for (const Result& result : results)
        fmt::print(" {:>15}", result.submission);
    fmt::print("\n");
    for (std::size_t i = 0; i < results[0].tasks.size(); ++i) {
        const Task& task = results[0].tasks[i].task;
        fmt::print("{:<6} {}", task.tag, padded(task.name().substr(0, 25), 25));
        for (const Result& result : results) {
            const TaskResult& of = result.tasks[i];
            const bool full = of.status == Status::passed;
            const std::string cell = full ? fmt::format("{:g}/{:g}", of.score, of.max_score)
                                          : std::string(to_string(of.status));
            fmt::print(" {}", colored(fmt::format("{:>15}", cell), full ? Color::green : Color::red,
                                      color));
        }
        fmt::print("\n");
    }
    fmt::print("{:<32}", "points");
    for (const Result& result : results)
        fmt::print(" {:>15}", fmt::format("{:g} of {:g}", result.score(), result.max_score()));
    fmt::print("\n");
}

int demo(const DemoOptions& options)
{
    if (!places().has_reference())
        throw InputError("the demo runs the reference solution, which this tree lacks");
    const fs::path out = options.out;
    DrawOptions draw;
    draw.size = options.size;
    check_drawing(draw);
    const Implementation reference = working_implementation("reference");
    GradedTests graded_tests;
    render_scenes(reference, out, draw);
    const GradingRun run = graded_tests.wait();
    for (const auto& [assignment, submissions] : to_grade()) {
        const std::vector<Selection> selection =
            select_tasks(load_assignments(places().assignments()), {assignment});
        std::vector<Result> results;
        results.reserve(submissions.size());
        for (const std::string& name : submissions)
            results.push_back(grade_one(name, out / "graded", selection.at(0), run));
        print_points(assignment, results);
        std::fflush(stdout);
    }

    fmt::print("\nWhat lies where:\n");
    for (const char* scene : scenes)
        fmt::print("  {}/frame_00000.png and so on{}\n",
                   (out / fs::path(scene).filename()).string(),
                   is_installed("ffmpeg") ? ", out.mp4" : "");
    for (const auto& [assignment, submissions] : to_grade())
        for (const std::string& name : submissions)
            fmt::print("  {}/result.json, report.txt\n", (out / "graded" / name).string());
    return exit_done;
}

} // namespace

Action declare_demo(Options& options)
{
    const auto chosen = std::make_shared<DemoOptions>();
    options.option("--out", "DIR", chosen->out, "Folder for frames and results (out/demo)");
    options.option("--size", "WxH", chosen->size,
                   "Width and height of a frame in pixels (1280x720)");
    options.examples({"demo", "demo --out /tmp/demo --size 640x360"});
    return [chosen] { return demo(*chosen); };
}

} // namespace rigor
