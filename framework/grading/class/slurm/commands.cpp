// SPDX-License-Identifier: MIT
#include "grading/class/slurm/commands.hpp"

#include "errors/input_error.hpp"
#include "errors/printable.hpp"
#include "grading/process.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <stdexcept>

namespace rigor::slurm {

namespace {

struct Answer {
    bool ok = false;
    std::vector<std::string> lines;
};

// How long a command of Slurm may be silent. While Slurm's controller does not answer, the
// command waits and tries again.
constexpr double longest_silence = 120; // [s]

Answer asked(const std::vector<std::string>& arguments)
{
    Command command;
    command.arguments = arguments;
    command.silence = longest_silence;
    Answer answer;
    const Ended ended = run(command, [&](std::string_view line) {
        answer.lines.push_back(printable(std::string(line)));
    });
    if (ended.timed_out) answer.lines.emplace_back("error: no answer");
    answer.ok = ended.ok();
    return answer;
}

// The errors among the lines that a command of Slurm printed, in one line.
std::string errors_in(const std::vector<std::string>& lines)
{
    std::string text;
    for (const std::string& line : lines)
        for (const std::string_view word : {"error: ", "fatal: "})
            if (const std::size_t at = line.find(word); at != std::string::npos)
                text += (text.empty() ? "" : "; ") + line.substr(at + word.size());
    if (text.empty() && !lines.empty()) text = lines.back();
    return text.empty() ? "no reason" : text.substr(0, 300);
}

// The job id in what sbatch prints: `12`, or `12;cluster` if there are several clusters.
std::optional<std::string> job_number(const std::vector<std::string>& lines)
{
    for (const std::string& line : lines) {
        const std::string number = line.substr(0, line.find(';'));
        if (!number.empty() && number.find_first_not_of("0123456789") == std::string::npos)
            return number;
    }
    return {};
}

} // namespace

void require_installed()
{
    for (const char* name : {"sbatch", "squeue", "scancel"})
        if (!is_installed(name))
            throw InputError(
                fmt::format("--engine slurm: expected Slurm, found no {} in PATH", name));
}

std::string submit(const ArrayJob& job)
{
    const std::string limit = job.at_once > 0 ? fmt::format("%{}", job.at_once) : "";
    std::vector<std::string> arguments = {"sbatch",
                                          "--parsable",
                                          "--requeue",
                                          "--ntasks=1",
                                          "--cpus-per-task=1",
                                          "--open-mode=append",
                                          "--chdir=/",
                                          fmt::format("--array=0-{}{}", job.tasks - 1, limit),
                                          "--job-name=" + job.name,
                                          "--output=" + job.log.string(),
                                          job.script.string()};
    arguments.insert(arguments.end(), job.program.begin(), job.program.end());
    const Answer answer = asked(arguments);
    const std::optional<std::string> number = job_number(answer.lines);
    if (!answer.ok || !number)
        throw InputError("--engine slurm: Slurm takes no job: " + errors_in(answer.lines));
    return *number;
}

TaskCounts parsed_counts(const std::vector<std::string>& lines)
{
    // A task whose state is in neither list runs, is about to run, or is about to end.
    constexpr std::array<std::string_view, 9> over = {"BOOT_FAIL",     "CANCELLED", "COMPLETED",
                                                      "DEADLINE",      "FAILED",    "NODE_FAIL",
                                                      "OUT_OF_MEMORY", "REVOKED",   "TIMEOUT"};
    constexpr std::array<std::string_view, 5> waits = {"PENDING", "REQUEUED", "REQUEUE_FED",
                                                       "REQUEUE_HOLD", "SPECIAL_EXIT"};
    TaskCounts counts;
    for (const std::string& line : lines) {
        const std::string state = line.substr(0, line.find('|'));
        if (state.empty() || state.size() == line.size()) continue; // not a line of a task
        if (state == "CANCELLED") ++counts.cancelled;
        if (std::find(over.begin(), over.end(), state) != over.end()) continue;
        if (std::find(waits.begin(), waits.end(), state) == waits.end()) {
            ++counts.running;
            continue;
        }
        ++counts.waiting;
        counts.reason = line.substr(state.size() + 1);
    }
    return counts;
}

std::optional<TaskCounts> task_counts(const std::string& job, const std::string& name)
{
    const Answer answer = asked({"squeue", "--noheader", "--array", "--states=all", "--jobs=" + job,
                                 "--name=" + name, "--format=%T|%r"});
    if (answer.ok) return parsed_counts(answer.lines);
    for (const std::string& line : answer.lines)
        if (line.find("Invalid job id") != std::string::npos) return TaskCounts{};
    return {};
}

void cancel(const std::string& job, const std::string& name)
{
    asked({"scancel", "--name=" + name, job});
}

} // namespace rigor::slurm
