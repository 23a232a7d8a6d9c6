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

/// Functions that are called during the run, to show its progress.
struct ClassListener {
    /// Called from time to time. `doing` says what is done now, such as "grading"; `detail` is a
    /// remark on it, such as "3 tasks", or empty.
    std::function<void(std::size_t done, std::size_t total, const std::string& doing,
                       const std::string& detail)>
        on_progress;
    /// Called once, before the grading, if some submissions keep their old result.
    std::function<void(std::size_t kept, std::size_t total)> on_kept;
    /// Called for each submission that was graded. @param before  its old result, if there is one
    std::function<void(const Row& row, const std::optional<Row>& before)> on_row;
};

struct ClassOutcome {
    std::vector<Row> rows;  // in the order of the submissions
    std::size_t graded = 0; // how many this run graded; the others keep an old result
    /// What is wrong with a control, a submission whose points are known; empty if nothing is. If a
    /// control is wrong, the results that no control had confirmed have been removed, and `rows` is
    /// empty.
    std::string control_fault;
};

/// What happens to an old result that was made with other tests, points, seeds or walls
/// (another sandbox). `stay`: the run ends with an error. `are_replaced`: the submission is graded
/// again. A new or changed submission is graded in both cases.
enum class OldResults { stay, are_replaced };

/// Grades the submissions and writes the files about each as soon as it is graded. Before the first
/// and after the last submission the controls are graded: the reference, which must get every
/// point, and a file without formulas, which must get none.
///
/// The submissions are graded in a random order, drawn from the run's seed, so that a slow hour of
/// the machine does not always affect the same students.
///
/// A submission that changes between the begin of the run and the end of its grading is graded once
/// more, as it is then.
/// @param work  the class, whose `fingerprints` and `out` are not set yet
/// @throws InputError if a result cannot be written, if `old` is `stay` and an old result would
///     have to be replaced, or if the tests or something else that all results depend on changes
ClassOutcome grade_class(ClassWork work, const ClassFolder& folder, Engine& engine,
                         const ClassListener& listener, OldResults old);

} // namespace rigor
