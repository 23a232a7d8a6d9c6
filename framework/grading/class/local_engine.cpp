// SPDX-License-Identifier: MIT
#include "grading/class/local_engine.hpp"

#include "grading/class/control.hpp"
#include "grading/class/fingerprint.hpp"
#include "grading/class/isolated.hpp"
#include "grading/class/work_folders.hpp"

#include <algorithm>
#include <chrono>

namespace rigor {

namespace {

// The time after which the grading of a submission is ended. The compiler, each call and each scene
// have limits of their own, so that only a fault of the framework takes this long. The time that
// the controls (submissions whose points are known) took tells how fast and how busy this machine
// is.
std::chrono::duration<double> longest_grading(std::chrono::duration<double> controls)
{
    constexpr double multiple = 100;
    // On a machine that is not busy, this is enough even if the compilation of each topic's file
    // uses up its processor time (`compile_limit`).
    constexpr std::chrono::minutes least(30);
    return std::max<std::chrono::duration<double>>(least, multiple * controls);
}

ResultFiles files_of(const ClassWork& work, const Submission& submission, const WorkDone& ended)
{
    if (ended.text) return unpacked(*ended.text);
    const std::string fault = ended.fault + (ended.was_tried_twice ? " (tried twice)" : "");
    return faulty_submission(work.selection, submission, work.run, fault);
}

} // namespace

std::string LocalEngine::grade(const ClassWork& work, const std::vector<std::size_t>& numbers,
                               const OnGraded& on_graded, const OnWait& on_wait)
{
    const WorkFolders folders(work.out, part_);
    const auto controls = [&](const std::string& when) {
        return fault_of_controls(work, folders, isolation_, when, [&] { on_wait("controls", ""); });
    };
    const auto start = std::chrono::steady_clock::now();
    if (std::string fault = controls("before the first submission"); !fault.empty()) return fault;
    const auto longest = longest_grading(std::chrono::steady_clock::now() - start);

    const auto text_about = [&](std::size_t k) {
        const std::size_t i = numbers[k];
        return packed(graded_submission(work.selection, work.submissions[i], work.run,
                                        folders.make(std::to_string(i)), work.fingerprints[i]));
    };
    const auto on_done = [&](const WorkDone& ended) {
        const std::size_t i = numbers[ended.index];
        folders.remove(std::to_string(i));
        require_unchanged(work.parts, work.selection, work.run);
        on_graded(i, files_of(work, work.submissions[i], ended));
    };
    Isolation how = isolation_;
    how.longest = longest;
    run_isolated(numbers.size(), how, text_about, on_done, [&] { on_wait("grading", ""); });
    std::string fault = controls("after the last submission");
    require_unchanged(work.parts, work.selection, work.run);
    return fault;
}

} // namespace rigor
