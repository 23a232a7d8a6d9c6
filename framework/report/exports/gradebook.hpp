// SPDX-License-Identifier: MIT
// The gradebook and the summary of a class, for the instructor. Neither contains durations or
// dates, and neither depends on the order in which submissions were graded.
#pragma once

#include "report/exports/row.hpp"

#include <string>
#include <vector>

namespace rigor {

/// gradebook.csv: submission, status, points, max, and the points of each task. A submission that
/// could not be graded because of a fault of the framework has empty cells, not 0.
/// @param rows  sorted by name, all of one assignment
std::string gradebook_csv(const std::vector<Row>& rows);

/// summary.txt: how many passed each task and who failed it, how the points are distributed, which
/// mistakes are common, and which submissions could not be tested and why.
std::string class_summary(const std::vector<Row>& rows);

} // namespace rigor
