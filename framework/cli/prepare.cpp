// SPDX-License-Identifier: MIT
#include "cli/prepare.hpp"

#include "cli/progress.hpp"
#include "errors/input_error.hpp"
#include "errors/nearest.hpp"
#include "errors/quotes.hpp"
#include "grading/build/submission_build.hpp"
#include "grading/places.hpp"
#include "grading/process.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <stdexcept>
#include <unistd.h>

namespace rigor {

namespace fs = std::filesystem;

namespace {

OnBuildStep on_step(Progress& progress)
{
    return [&progress](int done, int total, const std::string& step) {
        progress.update(static_cast<double>(done) / total, step.substr(step.rfind('/') + 1));
    };
}

} // namespace

Implementation prepared_implementation(const std::string& with)
{
    Progress progress("building");
    return build_implementation(with, on_step(progress));
}

Implementation working_implementation(const std::string& with)
{
    Implementation result = prepared_implementation(with);
    if (const std::string errors = result.errors(); !errors.empty())
        throw InputError(with + " does not compile:\n" + errors);
    return result;
}

void prepare_targets(const std::vector<std::string>& targets)
{
    Progress progress("building");
    build_targets(targets, on_step(progress));
}

GradingRun prepared_grading_run()
{
    Progress progress("building");
    return own_grading_run(on_step(progress));
}

void prepare_submissions()
{
    Progress progress("building");
    prepare_submission_builds(on_step(progress));
}

int run_program(const std::vector<std::string>& arguments)
{
    Command command;
    command.arguments = arguments;
    command.shares_stderr = true;
    const Ended ended = run(command, [](std::string_view line) {
        fmt::print("{}\n", line);
        std::fflush(stdout);
    });
    if (!ended.signal) return ended.status;
    throw std::runtime_error(fmt::format("{} was ended by signal {}", arguments[0], ended.signal));
}

std::string program_failed(const std::string& name, int status)
{
    return fmt::format("a fault of the framework: {} ended with status {}; run {} by itself", name,
                       status, places().program(name.c_str()).string());
}

void require_folder(const std::string& out, const std::string& content)
{
    if (out.empty()) throw InputError("expected --out DIR, the folder for " + content);
    std::error_code error;
    fs::create_directories(out, error);
    // With `error` as an argument, is_directory throws nothing, even if the name is too long.
    if (!fs::is_directory(out, error)) throw InputError("--out: expected a folder, found " + out);
    if (access(out.c_str(), W_OK) != 0)
        throw InputError("--out: expected a folder that can be written, found " + out);
}

std::vector<SceneFile> shipped_scenes()
{
    std::vector<SceneFile> result;
    std::error_code error;
    for (const auto& assignment : fs::directory_iterator(places().assignments(), error))
        for (const auto& scene : fs::directory_iterator(assignment.path() / "scenes", error))
            if (scene.path().extension() == ".json")
                result.push_back({scene.path(), assignment.path().filename().string() + "/" +
                                                    scene.path().stem().string()});
    std::sort(result.begin(), result.end(),
              [](const SceneFile& a, const SceneFile& b) { return a.name < b.name; });
    return result;
}

fs::path find_scene(const std::string& text)
{
    if (fs::is_regular_file(text)) return text;
    std::vector<SceneFile> found;
    const std::vector<SceneFile> all = shipped_scenes();
    std::vector<std::string> names;
    for (const SceneFile& scene : all) {
        const std::string base = scene.file.stem().string();
        if (text == scene.name || text == base || text == base + ".json") found.push_back(scene);
        names.insert(names.end(), {base, scene.name});
    }
    if (found.size() == 1) return found[0].file;
    if (found.size() > 1)
        throw InputError("the scene '" + text + "' is in " + found[0].name + " and in " +
                         found[1].name + ": expected one of these names");
    throw InputError("no scene " + in_quotes(text) +
                     suggestion(text, names, "`rigor list --scenes` names them"));
}

} // namespace rigor
