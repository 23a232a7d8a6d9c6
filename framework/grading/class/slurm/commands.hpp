// SPDX-License-Identifier: MIT
// The commands of Slurm that an engine needs: sbatch, squeue and scancel.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rigor::slurm {

/// A job array. Each task runs the same program, which finds its number in its environment.
struct ArrayJob {
    std::string name;
    std::size_t tasks = 1;
    unsigned at_once = 0;             // most tasks that run at the same time; 0: no limit
    std::filesystem::path script;     // a shell script that runs its arguments
    std::filesystem::path log;        // file for what a task prints; %A is the job, %a the task
    std::vector<std::string> program; // the program and its arguments
};

/// @throws InputError if Slurm's commands are not in PATH
void require_installed();

/// Hands a job to Slurm. Partition, account, time and memory are what the user's variables
/// SBATCH_PARTITION and so on say. @return the job's number
/// @throws InputError with Slurm's reason if it takes no job
std::string submit(const ArrayJob& job);

/// The tasks of a job, counted.
struct TaskCounts {
    std::size_t waiting = 0, running = 0;
    std::size_t cancelled = 0; // by somebody: they have ended, and Slurm does not run them again
    std::string reason;        // why one of them waits, such as "Resources"

    bool is_over() const { return waiting + running == 0; }
};

/// What Slurm says about a job; no task if it has forgotten the job, which it does some minutes
/// after the end. Nothing if Slurm does not answer.
std::optional<TaskCounts> task_counts(const std::string& job);

/// The counts in what `squeue --format=%T|%r` prints, a line for each task.
TaskCounts parsed_counts(const std::vector<std::string>& lines);

/// Ends a job, if it has this name and still runs.
void cancel(const std::string& job, const std::string& name);

} // namespace rigor::slurm
