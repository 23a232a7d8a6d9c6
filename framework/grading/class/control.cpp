// SPDX-License-Identifier: MIT
#include "grading/class/control.hpp"

#include <fmt/format.h>
#include <fstream>

namespace rigor {

namespace {

Result graded_control(const ClassWork& work, const WorkFolders& folders, bool is_complete)
{
    if (is_complete) return grade(work.selection, *work.reference, work.run);
    const std::filesystem::path place = folders.make("empty");
    std::ofstream(place / (work.selection.assignment.topic + ".cpp")) << "// no formulas\n";
    return grade(work.selection, build_implementation(place.string()), work.run);
}

} // namespace

std::string fault_of_control(const Result& result, bool is_complete)
{
    if (result.status != SubmissionStatus::graded)
        return fmt::format("is {}: {}", to_string(result.status), result.message);
    if (result.max_score() <= 0) return "could get no points";
    for (const TaskResult& task : result.tasks) {
        const double expected = is_complete ? task.max_score : 0;
        if (task.score != expected)
            return fmt::format("got {:g} of {:g} points; in {} it got {:g}, expected {:g}",
                               result.score(), result.max_score(), task.task.tag, task.score,
                               expected);
    }
    return "";
}

std::string fault_of_controls(const ClassWork& work, const WorkFolders& folders,
                              const Isolation& how, const std::string& when,
                              const std::function<void()>& on_wait)
{
    std::string fault;
    const auto fault_text = [&](std::size_t i) {
        return fault_of_control(graded_control(work, folders, i == 1), i == 1);
    };
    const auto on_done = [&](const WorkDone& ended) {
        const std::string what = ended.index == 1 ? "the reference" : "a file without formulas";
        const std::string wrong = ended.text ? *ended.text : "could not be graded: " + ended.fault;
        if (!wrong.empty()) fault = fmt::format("control {}: {} {}", when, what, wrong);
    };
    run_isolated(work.reference ? 2 : 1, how, fault_text, on_done, on_wait);
    return fault;
}

} // namespace rigor
