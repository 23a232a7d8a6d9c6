// SPDX-License-Identifier: MIT
// What a new grading of a class changes: the points of each submission before and after.
#pragma once

#include "report/exports/row.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// How a submission's result changes: its points, and below them a line for each task whose points
/// or maximum are not the same. Empty if the status and all points and maxima stay.
/// @param before  empty if the submission is new
std::string change_text(const std::optional<Row>& before, const Row& after);

/// The changes of a class, and how many there are. A submission that keeps its points is only
/// counted, also if the maximum of a task has changed. `before` and `after` have the same
/// submissions in the same order.
std::string changes_text(const std::vector<std::optional<Row>>& before,
                         const std::vector<Row>& after);

} // namespace rigor
