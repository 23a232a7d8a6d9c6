// SPDX-License-Identifier: MIT
// Where the submissions of a class are graded: by processes of this machine (local_engine.hpp), or
// by the nodes of a cluster (slurm/slurm_engine.hpp). A node grades its share as this machine does.
#pragma once

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

/// A class that is graded. The order of the submissions gives each its number.
struct ClassWork {
    Selection selection;
    GradingRun run;
    /// The reference, which must get every point; nothing if there is none.
    std::optional<Implementation> reference;
    std::vector<Submission> submissions;
    std::uint64_t fingerprint = 0;         // all that a result depends on but the submission
    std::vector<std::string> fingerprints; // those of the submissions' results
    std::filesystem::path out;             // the results' folder
};

/// Called with the number of a submission and what is to be written about it.
using OnGraded = std::function<void(std::size_t submission, const ResultFiles& files)>;
/// Called from time to time. @param doing  what is being done  @param detail  by whom
using OnWait = std::function<void(const std::string& doing, const std::string& detail)>;

class Engine {
public:
    virtual ~Engine() = default;

    /// Grades the submissions with these numbers, in this order, between two controls. A submission
    /// that a fault of the framework keeps from being graded is reported with this fault; an
    /// exception of `on_graded` ends the run.
    /// @return what is wrong with a control; empty if nothing is
    virtual std::string grade(const ClassWork& work, const std::vector<std::size_t>& numbers,
                              const OnGraded& on_graded, const OnWait& on_wait) = 0;
};

} // namespace rigor
