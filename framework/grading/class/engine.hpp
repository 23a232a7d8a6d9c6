// SPDX-License-Identifier: MIT
// Where the submissions of a class are graded: by processes of this machine (local_engine.hpp), or
// by the nodes of a cluster (slurm/slurm_engine.hpp). Each node grades its share by the code of
// local_engine.hpp.
#pragma once

#include "grading/class/fingerprint.hpp"
#include "grading/class/graded_submission.hpp"
#include "grading/intake/found_submissions.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// The submissions of a class, and how to grade them.
struct ClassWork {
    Selection selection;
    GradingRun run;
    /// The reference, which must get every point; empty if the tree has no reference.
    std::optional<Implementation> reference;
    std::vector<Submission> submissions;
    SharedParts parts;                     // shared_parts(selection, run), as the run began
    std::uint64_t fingerprint = 0;         // fingerprint_of(parts)
    std::vector<std::string> fingerprints; // the fingerprint of each submission's result
    std::filesystem::path out;             // the results' folder
};

/// Called with the index of a submission in `ClassWork::submissions`, and the files to write about
/// it.
using OnGraded = std::function<void(std::size_t submission, const ResultFiles& files)>;
/// Called from time to time, to show progress. `doing` says what is done now, such as "grading";
/// `detail` is a remark on it, such as "3 tasks", or empty.
using OnWait = std::function<void(const std::string& doing, const std::string& detail)>;

class Engine {
public:
    virtual ~Engine() = default;

    /// Grades `work.submissions[i]` for each i in `numbers`. `on_graded` gets the results in any
    /// order. Before and after the submissions that are graded now, the controls are graded, which
    /// are submissions whose points are known. If a fault of the framework prevents the grading of
    /// a submission, the files about it report the fault. An exception of `on_graded` ends the run.
    /// @return what is wrong with a control; empty if nothing is
    /// @throws InputError if `work.parts` have changed: no result is passed on that was made under
    ///     other conditions
    virtual std::string grade(const ClassWork& work, const std::vector<std::size_t>& numbers,
                              const OnGraded& on_graded, const OnWait& on_wait) = 0;
};

} // namespace rigor
