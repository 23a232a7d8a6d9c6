// SPDX-License-Identifier: MIT
// Builds an implementation. The reference is trusted, so ninja builds it as a target of the main
// build. Every other implementation, including student/, is built like a submission: in a sandbox.
#include "grading/build/implementation.hpp"

#include "errors/input_error.hpp"
#include "errors/printable.hpp"
#include "grading/build/submission_build.hpp"
#include "grading/places.hpp"
#include "seeds/drawn_seed.hpp"

#include <algorithm>
#include <stdexcept>

namespace rigor {

namespace fs = std::filesystem;

namespace {

std::string without_last_newline(std::string text)
{
    if (text.ends_with('\n')) text.pop_back();
    return text;
}

Implementation build_reference(const OnBuildStep& on_step)
{
    const BuildLock lock;
    const NinjaRun run = run_ninja({"worker_reference"}, on_step);
    if (!run.ok)
        throw std::runtime_error("code of the framework does not compile:\n" +
                                 without_last_newline(run.errors));
    Implementation result;
    result.name = "reference";
    result.folder = places().source / "reference";
    result.worker = places().program("worker_reference");
    result.digest = sha256("reference");
    result.build_steps = run.steps;
    result.build_seconds = run.seconds;
    return result;
}

Implementation build_folder(const std::string& name, const fs::path& folder,
                            const OnBuildStep& on_step)
{
    SubmissionBuild build = build_submission(folder, on_step);
    Implementation result;
    result.name = printable(name);
    std::replace(result.name.begin(), result.name.end(), '\n', '?');
    result.folder = folder;
    result.worker = build.worker;
    result.broken = std::move(build.broken);
    result.borrowed = std::move(build.borrowed);
    result.left_out = std::move(build.left_out);
    result.undefined = std::move(build.undefined);
    result.digest = std::move(build.digest);
    result.build_steps = std::move(build.steps);
    result.build_seconds = build.seconds;
    return result;
}

bool is_among(const std::vector<std::string>& topics, const std::string& topic)
{
    return std::find(topics.begin(), topics.end(), topic) != topics.end();
}

} // namespace

std::string Implementation::errors() const
{
    std::string text;
    for (const auto& [topic, errors] : broken)
        text += errors;
    return text;
}

std::string Implementation::shown_file(const std::string& topic) const
{
    const bool is_borrowed = is_among(borrowed, topic);
    return (fs::path(is_borrowed ? "student" : name) / (topic + ".cpp")).string();
}

fs::path Implementation::file(const std::string& topic) const
{
    const bool is_borrowed = is_among(borrowed, topic);
    return (is_borrowed ? places().source / "student" : folder) / (topic + ".cpp");
}

Implementation build_implementation(const std::string& name, const OnBuildStep& on_step)
{
    const bool is_ours = name == "student" || name == "reference";
    std::error_code error;
    const fs::path folder = is_ours ? places().source / name : fs::canonical(name, error);
    if (!error && fs::is_directory(folder))
        return name == "reference" ? build_reference(on_step) : build_folder(name, folder, on_step);
    if (is_ours) throw InputError("this tree has no " + name + "/: it cannot be run with it");
    throw InputError("--with: expected student, reference or a folder, found '" + name + "'");
}

void build_targets(const std::vector<std::string>& targets, const OnBuildStep& on_step)
{
    const BuildLock lock;
    const NinjaRun run = run_ninja(targets, on_step);
    if (!run.ok) throw std::runtime_error("the build failed:\n" + without_last_newline(run.errors));
}

} // namespace rigor
