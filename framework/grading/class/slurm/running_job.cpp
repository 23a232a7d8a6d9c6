// SPDX-License-Identifier: MIT
#include "grading/class/slurm/running_job.hpp"

#include "errors/input_error.hpp"

#include <chrono>
#include <exception>
#include <fmt/format.h>
#include <optional>
#include <thread>

namespace rigor::slurm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds ask_every(1);
// Slurm asks tasks to end, and by default kills them half a minute later.
constexpr std::chrono::minutes longest_end(3);

} // namespace

void end_job(const std::string& job, const std::string& name, const std::function<void()>& on_wait)
{
    cancel(job, name);
    const Clock::time_point start = Clock::now();
    for (;;) {
        const std::optional<TaskCounts> counts = task_counts(job, name);
        if (!counts)
            throw InputError(fmt::format("Slurm does not answer whether its job {}, which was "
                                         "cancelled, has ended: start again when it does",
                                         job));
        if (counts->is_over()) return;
        if (Clock::now() - start > longest_end)
            throw InputError(fmt::format("Slurm's job {} still runs {} minutes after it was "
                                         "cancelled: start again when squeue no longer shows it",
                                         job, longest_end.count()));
        if (on_wait) on_wait();
        std::this_thread::sleep_for(ask_every);
    }
}

RunningJob::RunningJob(const ArrayJob& job, const SharedFolder& shared, WorkFolders& folders)
    : name_(job.name), number_(submit(job)), folders_(folders)
{
    try {
        shared.write_job(number_);
    } catch (...) {
        end();
        throw;
    }
}

RunningJob::~RunningJob()
{
    if (is_ours_) end();
}

void RunningJob::end()
{
    try {
        end_job(number_, name_);
    } catch (const std::exception&) {
        folders_.leave(); // the next run ends the job
    }
}

void RunningJob::leave_alone()
{
    is_ours_ = false;
    folders_.leave();
}

} // namespace rigor::slurm
