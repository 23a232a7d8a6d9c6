// SPDX-License-Identifier: MIT
// A folder inside the results' folder. Through the files in it, the machine that grades a class
// exchanges data with the nodes of a cluster. Each run has a folder of its own, `.rigor/slurm/RUN`:
// tasks of an earlier run, which may still write, cannot be taken for those of this run. Every file
// but the logs is written whole, so a reader finds all of the file or no file. The controls in this
// list are submissions whose points are known.
//
//     plan_1.json     what the tasks of the first job are to grade, and how
//     job             the id of the job that was submitted last
//     graded/NAME     the result files of a submission; NAME is its fingerprint
//     ended/1.3       task 3 of the first job has ended, and its controls were right
//     control_fault   what was wrong with a control
//     log/1_3.txt     what task 3 of the first job printed
//     run.sh          the script of the jobs
#pragma once

#include "grading/class/engine.hpp"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rigor::slurm {

/// What a job array of Slurm is to grade.
struct Plan {
    std::string run;    // the name of the run's folder
    unsigned round = 1; // number of the job; a job after the first one grades lost submissions
    std::string assignment, out;
    std::uint32_t seed = 0;
    std::string secret_file;                      // absolute path; empty if there is no secret
    std::uint64_t fingerprint = 0;                // ClassWork::fingerprint
    std::vector<Submission> submissions;          // the submissions that this job grades
    std::vector<std::string> fingerprints;        // one for each submission
    std::vector<std::vector<std::size_t>> chunks; // for each task, indices in `submissions`
};

/// A name for a run that no other run has. It is drawn at random, and no part of any result.
std::string new_run();

class SharedFolder {
public:
    /// @param out  the results' folder, absolute
    /// @param run  the name of the run
    SharedFolder(const std::filesystem::path& out, const std::string& run);
    /// The folders of all runs that have one. A run removes its folder at its end, unless it was
    /// broken off.
    static std::vector<SharedFolder> all(const std::filesystem::path& out);

    /// Makes the folder and its script. @throws InputError if the folder cannot be written
    void make() const;
    void remove() const;

    /// @return the path of the plan's file
    std::filesystem::path write_plan(const Plan& plan) const;

    /// The id of the job that was submitted last; empty if there is none.
    std::string job() const;
    void write_job(const std::string& job) const;

    /// The texts about a submission, if a task has written them.
    std::optional<ResultFiles> graded(const std::string& fingerprint) const;
    /// The fingerprints of all submissions that tasks have written texts about.
    std::set<std::string> all_graded() const;
    void write_graded(const std::string& fingerprint, const ResultFiles& files) const;

    void write_ended(unsigned round, std::size_t task) const;
    /// Those of the first `tasks` tasks of a job that have ended and whose controls (submissions
    /// with known points) were right.
    std::set<std::size_t> ended(unsigned round, std::size_t tasks) const;

    void write_control_fault(const std::string& fault) const;
    std::string control_fault() const;

    /// The pattern of the names of log files, for sbatch.
    std::filesystem::path log_pattern(unsigned round) const;
    /// Whether there is a log file of any task of a job, even an empty one.
    bool has_log(unsigned round) const;
    /// The last line that a task printed; empty if there is none.
    std::string last_words(unsigned round, std::size_t task) const;

    std::filesystem::path script() const { return folder_ / "run.sh"; }

private:
    std::filesystem::path folder_;
};

/// @throws InputError if the file is no plan
Plan read_plan(const std::filesystem::path& file);

} // namespace rigor::slurm
