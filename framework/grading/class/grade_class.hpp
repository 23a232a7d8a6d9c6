// SPDX-License-Identifier: MIT
// Grades many submissions. What was graded before and has not changed is not graded again.
#pragma once

#include "grading/class/class_folder.hpp"
#include "grading/class/engine.hpp"
#include "report/exports/row.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// What the run tells while it goes on.
struct ClassListener {
    /// Called from time to time. @param doing  what is being done  @param detail  by whom
    std::function<void(std::size_t done, std::size_t total, const std::string& doing,
                       const std::string& detail)>
        on_progress;
    /// Called once, if submissions have a result that is kept.
    std::function<void(std::size_t kept, std::size_t total)> on_kept;
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

/// What happens to a result that was made with other tests, points, seeds or walls. A new or
/// changed submission is graded in both cases.
enum class OldResults { stay, are_replaced };

/// Grades the submissions and writes the files of each as soon as they are there. Before the first
/// and after the last one the controls are graded: the reference, which must get every point, and a
/// file without formulas, which must get none.
///
/// The submissions are graded in an order that the run's seed draws, so that a slow hour does not
/// always meet the same students.
/// @param work  the class, whose `fingerprints` and `out` are not set yet
/// @throws InputError if a result cannot be written, or if an old one has to stay
ClassOutcome grade_class(ClassWork work, const ClassFolder& folder, Engine& engine,
                         const ClassListener& listener, OldResults old);

} // namespace rigor
