// SPDX-License-Identifier: MIT
// A folder inside the results' folder. Through the files in it, the machine that grades a class
// exchanges data with the nodes of a cluster. Every file but the logs is written whole, so a reader
// finds all of the file or no file. The controls in this list are submissions whose points are
// known.
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
    unsigned round = 1; // number of the job; a job after the first one grades lost submissions
    std::string assignment, out;
    std::uint32_t seed = 0;
    std::string secret_file;                      // absolute path; empty if there is no secret
    std::uint64_t fingerprint = 0;                // fingerprint_of(selection, run)
    std::vector<Submission> submissions;          // the submissions that this job grades
    std::vector<std::string> fingerprints;        // one for each submission
    std::vector<std::vector<std::size_t>> chunks; // for each task, indices in `submissions`
};

class SharedFolder {
public:
    /// @param out  the results' folder, absolute
    explicit SharedFolder(const std::filesystem::path& out);

    /// Makes the folder and its script. Removes what the tasks of an earlier run left in it, except
    /// for `graded`. @throws InputError if the folder cannot be written
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
    void remove_graded(const std::string& fingerprint) const;

    void write_ended(unsigned round, std::size_t task) const;
    /// The tasks of a job that have ended and whose controls (submissions with known points) were
    /// right.
    std::set<std::size_t> ended(unsigned round) const;

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
