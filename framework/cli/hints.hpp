// SPDX-License-Identifier: MIT
// The hints of the tasks of an assignment. The first is in assignment.json; the others are in
// hints.md beside it, below a heading with the tag of the task:
//
//     ## A2.14
//     1. Draw the two bodies and the three centers.
//     2. Which of the terms contains the distance between two centers?
#pragma once

#include "grading/assignment.hpp"

#include <string>
#include <vector>

namespace rigor {

/// The hints of a task, the mildest first.
/// @throws InputError if hints.md cannot be read
std::vector<std::string> hints_of(const Assignment& assignment, const Task& task);

} // namespace rigor
