// SPDX-License-Identifier: MIT
#pragma once

#include "grading/class/slurm/commands.hpp"
#include "grading/class/slurm/shared_folder.hpp"
#include "grading/class/work_folders.hpp"

#include <functional>
#include <string>

namespace rigor::slurm {

/// Cancels a job, if it has this name and still waits or runs, and waits until none of its tasks
/// does. @param on_wait  called repeatedly meanwhile
/// @throws InputError if tasks still run after some minutes, or if Slurm does not answer
void end_job(const std::string& job, const std::string& name,
             const std::function<void()>& on_wait = {});

/// A job of Slurm. The destructor ends it, unless it is known to be over or was left alone. If it
/// may still run afterwards, the folders that its tasks work in are left.
class RunningJob {
public:
    /// Submits the job. @throws InputError if Slurm does not take it
    RunningJob(const ArrayJob& job, const SharedFolder& shared, WorkFolders& folders);
    ~RunningJob();
    RunningJob(const RunningJob&) = delete;
    RunningJob& operator=(const RunningJob&) = delete;

    const std::string& number() const { return number_; }
    void note_end() { is_ours_ = false; }
    /// Lets the job go on, because Slurm does not answer.
    void leave_alone();

private:
    void end();

    std::string name_, number_;
    WorkFolders& folders_;
    bool is_ours_ = true; // whether the destructor ends the job
};

} // namespace rigor::slurm
