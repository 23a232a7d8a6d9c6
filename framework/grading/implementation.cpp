// SPDX-License-Identifier: MIT
// Builds the worker of an implementation. student/ and reference/ are targets of the main build;
// any other folder gets a private build that compiles its files like those of student/. After each
// build, errors are attributed to the framework or to the student, and
// forbidden includes are refused.
#include "grading/implementation.hpp"

#include "errors/input_error.hpp"
#include "grading/includes.hpp"
#include "grading/places.hpp"
#include "grading/replace_all.hpp"
#include "grading/submission_build.hpp"
#include "grading/topics.hpp"

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

// The errors with the paths that the student knows.
std::string shortened(std::string errors, const Implementation& implementation)
{
    const std::string folder = implementation.folder.string() + "/";
    replace_all(errors, folder, implementation.name + "/");
    replace_all(errors, places().source.string() + "/", "");
    return errors;
}

void take_over(Implementation& implementation, const NinjaRun& run)
{
    implementation.build_steps.insert(implementation.build_steps.end(), run.steps.begin(),
                                      run.steps.end());
    implementation.build_seconds += run.seconds;
}

// Whether the student's files made a build fail, and not the framework's. What is made from the
// student's files has `marker` in its path; the worker is linked last.
bool is_theirs(const NinjaRun& run, const std::string& marker, const std::string& worker)
{
    if (run.failed.empty()) return run.timed_out;
    return std::any_of(run.failed.begin(), run.failed.end(), [&](const std::string& output) {
        return output.find(marker) != std::string::npos || output == worker;
    });
}

void judge(Implementation& implementation, const NinjaRun& run, const std::string& marker,
           const std::string& worker)
{
    take_over(implementation, run);
    if (run.ok) return;
    if (!is_theirs(run, marker, worker) || implementation.name == "reference")
        throw std::runtime_error("code of the framework does not compile:\n" +
                                 without_last_newline(run.errors));
    implementation.compile_error = shortened(run.errors, implementation);
    if (run.timed_out)
        implementation.compile_error += "a file took longer than " +
                                        std::to_string(static_cast<int>(compile_limit)) +
                                        " s to compile\n";
}

// Refuses an implementation that compiles but includes files that a solution may not include.
void refuse_forbidden_include(Implementation& implementation,
                              const std::vector<std::string>& objects)
{
    if (implementation.built())
        implementation.compile_error = forbidden_include(objects, implementation.folder);
}

Implementation build_own(const std::string& name, const OnBuildStep& on_step)
{
    Implementation result;
    result.name = name;
    result.folder = places().source / name;
    result.worker = places().program(("worker_" + name).c_str());
    const bool is_judged = name == "student";
    if (is_judged) remove_unlisted(student_objects());
    const NinjaRun run = run_ninja({"-k", "0", "worker_" + name}, on_step);
    judge(result, run, "formulas_" + name + ".dir/", "bin/worker_" + name);
    if (is_judged && run.ok) refuse_forbidden_include(result, student_objects());
    return result;
}

bool is_among(const std::vector<std::string>& topics, const std::string& topic)
{
    return std::find(topics.begin(), topics.end(), topic) != topics.end();
}

// The topics whose files failed to compile in a folder's build; empty if something else failed too.
std::vector<std::string> broken_topics(const SubmissionBuild& build, const NinjaRun& run)
{
    std::vector<std::string> broken;
    for (const std::string& topic : topics())
        if (is_among(run.failed, build.folder + topic + ".o")) broken.push_back(topic);
    return broken.size() == run.failed.size() ? broken : std::vector<std::string>();
}

// @param broken  topics whose files are left out; returns those that failed to compile
Implementation build_folder_without(const std::string& name, const fs::path& folder,
                                    const OnBuildStep& on_step, std::vector<std::string>& broken)
{
    Implementation result;
    result.name = name;
    result.folder = folder;
    result.broken = broken;
    const SubmissionBuild build = prepare_submission_build(folder, broken);
    result.worker = places().build / build.worker;
    result.borrowed = build.borrowed;

    // Everything that the worker needs besides the folder's files: the framework, and the files of
    // student/ for the topics that the folder lacks.
    const NinjaRun needed = run_ninja(build.needed_targets, on_step);
    judge(result, needed, "formulas_student.dir/", "");
    if (!result.built()) return result;
    remove_unlisted(build.objects);
    const NinjaRun run = run_ninja({"-k", "0", "-f", build.ninja_file, build.worker}, on_step);
    judge(result, run, build.folder, build.worker);
    refuse_forbidden_include(result, build.objects);
    broken = broken_topics(build, run);
    return result;
}

Implementation build_folder(const std::string& name, const fs::path& folder,
                            const OnBuildStep& on_step, const std::vector<std::string>& asked)
{
    std::vector<std::string> broken;
    const Implementation result = build_folder_without(name, folder, on_step, broken);
    const bool can_do_without = !asked.empty() && !broken.empty() &&
                                std::none_of(broken.begin(), broken.end(), [&](const auto& topic) {
                                    return is_among(asked, topic);
                                });
    return can_do_without ? build_folder_without(name, folder, on_step, broken) : result;
}

} // namespace

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

Implementation build_implementation(const std::string& name, const OnBuildStep& on_step,
                                    const std::vector<std::string>& asked)
{
    const BuildLock lock;
    if (name == "student" || name == "reference") {
        if (!fs::is_directory(places().source / name))
            throw InputError("this tree has no " + name + "/: it cannot be run with it");
        return build_own(name, on_step);
    }
    std::error_code error;
    const fs::path folder = fs::canonical(name, error);
    if (error || !fs::is_directory(folder))
        throw InputError("--with: expected student, reference or a folder, found '" + name + "'");
    return build_folder(name, folder, on_step, asked);
}

void build_targets(const std::vector<std::string>& targets, const OnBuildStep& on_step)
{
    const BuildLock lock;
    const NinjaRun run = run_ninja(targets, on_step);
    if (!run.ok) throw std::runtime_error("the build failed:\n" + without_last_newline(run.errors));
}

} // namespace rigor
