// SPDX-License-Identifier: MIT
// Grades many submissions. What was graded before and has not changed is not graded again.
#pragma once

#include "grading/class/class_folder.hpp"
#include "grading/intake/found_submissions.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"
#include "report/exports/row.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigor {

struct ClassRun {
    Selection selection;
    GradingRun run;
    unsigned jobs = 1;
    /// The worker of the reference, which must get every point; nothing if there is none.
    std::optional<Implementation> reference;
    /// Called from time to time. @param doing  what is being done
    std::function<void(std::size_t done, std::size_t total, const std::string& doing)> on_progress;
    /// Called for each submission that was graded. @param before  its old result, if there is one
    std::function<void(const Row& row, const std::optional<Row>& before)> on_row;
};

struct ClassOutcome {
    std::vector<Row> rows;  // in the order of the submissions
    std::size_t graded = 0; // how many were graded now; the others were there before
    /// What is wrong with a control; empty if nothing is. The results that it does not confirm have
    /// been removed, and there are no rows.
    std::string control_fault;
};

/// Grades the submissions and writes the files of each as soon as they are there. Before the first
/// and after the last one the controls are graded: the reference, which must get every point, and a
/// file without formulas, which must get none.
///
/// The submissions are graded in an order that the run's seed draws, so that a slow hour does not
/// always meet the same students.
/// @throws InputError if a result cannot be written
ClassOutcome grade_class(const ClassRun& run, const std::vector<Submission>& submissions,
                         const ClassFolder& folder);

} // namespace rigor
