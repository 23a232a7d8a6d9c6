// SPDX-License-Identifier: MIT
#pragma once

#include "grading/class/engine.hpp"

namespace rigor {

struct SlurmOptions {
    std::vector<std::string> task_command; // command of a task; the plan's path is appended
    std::string secret_file;               // absolute path of the secret, or empty if there is none
    // The number of submissions for each task. It is larger if a job would otherwise have more than
    // 1000 tasks.
    std::size_t chunk = 8;
    unsigned at_once = 0; // limit on the tasks that run at the same time; 0 for no limit
    std::function<void(const std::string&)> on_note; // called with messages for the user
};

/// Grades on a cluster, by job arrays of Slurm. Each task grades a chunk of the submissions by a
/// LocalEngine, with the controls (submissions with known points) before and after it, and writes
/// the results into a shared folder inside the results' folder. All nodes must see this folder, the
/// submissions and this tree. Slurm runs the tasks of a lost node again. Submissions without a
/// result at the end of a job go into a new job, at most twice. If the controls of the third job
/// are lost, a last job grades these alone.
///
/// A job of a run that was broken off is ended first, and its results are taken.
///
/// @throws InputError if Slurm takes no job or does not answer, if the nodes do not see the folder,
///     if somebody has canceled the job, or if the job of a run that was broken off does not end.
///     SIGINT and SIGTERM cancel the job, wait for its end, and then end this process.
class SlurmEngine : public Engine {
public:
    /// @throws InputError if Slurm is not installed
    explicit SlurmEngine(SlurmOptions options);

    std::string grade(const ClassWork& work, const std::vector<std::size_t>& numbers,
                      const OnGraded& on_graded, const OnWait& on_wait) override;

private:
    SlurmOptions options_;
};

} // namespace rigor
