// SPDX-License-Identifier: MIT
#include "cli/commands/hint.hpp"

#include "cli/hints.hpp"
#include "cli/options.hpp"
#include "errors/input_error.hpp"
#include "errors/nearest.hpp"
#include "errors/quotes.hpp"
#include "grading/places.hpp"
#include "report/terminal.hpp"
#include "report/write_whole.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

namespace rigor {

namespace {

struct HintOptions {
    std::string tag;
    std::uint32_t step = 0;
};

struct Found {
    Assignment assignment;
    Task task;
};

Found find_task(const std::string& tag)
{
    std::vector<Assignment> assignments = load_assignments(places().assignments());
    std::vector<std::string_view> tags;
    for (const Assignment& assignment : assignments) {
        if (const Task* task = assignment.task(tag)) return {assignment, *task};
        for (const Task& task : assignment.tasks)
            tags.push_back(task.tag);
    }
    throw InputError(fmt::format("expected the tag of a task, found {}{}", in_quotes(tag),
                                 suggestion(tag, tags, "`rigor list` names them")));
}

// The file in the build folder that stores the number of the hint that was shown last for a task.
std::filesystem::path memory_of(const Task& task)
{
    return places().build / "hints" / task.tag;
}

// The number of the hint that was shown last, from 1; 0 if none was shown. If the file has a number
// above `count`, the result is `count`.
std::size_t shown_before(const Task& task, std::size_t count)
{
    std::size_t shown = 0;
    std::ifstream(memory_of(task)) >> shown;
    return std::min(shown, count);
}

void remember(const Task& task, std::size_t shown)
{
    try {
        std::error_code error; // ignored: without the folder, write_whole throws
        std::filesystem::create_directories(memory_of(task).parent_path(), error);
        write_whole(memory_of(task), fmt::format("{}\n", shown));
    } catch (const InputError& failed) {
        fmt::print(stderr, "{}; ask with --step for the next hint\n", failed.what());
    }
}

int hint(const HintOptions& options)
{
    const auto [assignment, task] = find_task(options.tag);
    const std::vector<std::string> hints = hints_of(assignment, task);
    if (options.step > hints.size())
        throw InputError(fmt::format("--step: expected at most {} for {}, found {}", hints.size(),
                                     task.tag, options.step));
    const std::size_t step = options.step > 0
                                 ? options.step
                                 : std::min(shown_before(task, hints.size()) + 1, hints.size());
    fmt::print("{} {}: hint {} of {}\n", task.tag, task.name(), step, hints.size());
    fmt::print("  {}\n", wrapped(hints[step - 1], 78, 2));
    if (step < hints.size())
        fmt::print("`rigor hint {}` gives the next one.\n", task.tag);
    else
        fmt::print("That was the last one. The rest is in {}.\n",
                   (assignment.folder / "README.md").lexically_relative(places().source).string());
    remember(task, step);
    return exit_done;
}

} // namespace

Action declare_hint(Options& options)
{
    const auto chosen = std::make_shared<HintOptions>();
    options.word("TAG", chosen->tag, "A task, such as A4.8");
    options.option("--step", "N", chosen->step, "This hint, not the next one");
    options.examples({"hint A4.8            the first hint, and then the next one each time",
                      "hint A4.8 --step 1   the first again"});
    return [chosen] { return hint(*chosen); };
}

} // namespace rigor
