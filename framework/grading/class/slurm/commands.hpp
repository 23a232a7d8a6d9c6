// SPDX-License-Identifier: MIT
// The commands of Slurm that an engine needs: sbatch, squeue and scancel.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rigor::slurm {

/// A job array. Each task runs the same program, which finds the index of its task in the
/// environment variable SLURM_ARRAY_TASK_ID.
struct ArrayJob {
    std::string name;
    std::size_t tasks = 1;
    unsigned at_once = 0;         // limit on the tasks that run at the same time; 0 for no limit
    std::filesystem::path script; // a shell script that runs `program`
    // The file for a task's output; sbatch replaces %A by the job id and %a by the task's index.
    std::filesystem::path log;
    std::vector<std::string> program; // the program and its arguments
};

/// @throws InputError if Slurm's commands are not in PATH
void require_installed();

/// Submits a job to Slurm. The user's environment variables, such as SBATCH_PARTITION, choose
/// partition, account, time and memory. @return the job id
/// @throws InputError with Slurm's reason if it does not take the job
std::string submit(const ArrayJob& job);

/// How many tasks of a job are in each state.
struct TaskCounts {
    std::size_t waiting = 0, running = 0;
    std::size_t cancelled = 0; // canceled by a user: Slurm does not run these again
    std::string reason;        // why a task waits, such as "Resources"

    bool is_over() const { return waiting + running == 0; }
};

/// The counts that Slurm reports for a job of this name. They are all 0 if Slurm has forgotten the
/// job, as it does some minutes after the job's end. The result is empty if Slurm does not answer.
std::optional<TaskCounts> task_counts(const std::string& job, const std::string& name);

/// Counts the tasks in the output of `squeue --format=%T|%r`, which has a line for each task.
TaskCounts parsed_counts(const std::vector<std::string>& lines);

/// Cancels a job, if it has this name and still waits or runs. Its tasks may still run for a while.
void cancel(const std::string& job, const std::string& name);

} // namespace rigor::slurm
