// SPDX-License-Identifier: MIT
// The hints for the tasks of an assignment. The first hint of a task is in assignment.json. Its
// other hints are in hints.md in the same folder, below a heading with the tag of the task:
//
//     ## A2.14
//     1. Draw the two bodies and the three centers.
//     2. Which of the terms contains the distance between two centers?
#pragma once

#include "grading/assignment.hpp"

#include <string>
#include <vector>

namespace rigor {

/// The hints for a task. Each one says more than the one before it.
/// @throws InputError if hints.md cannot be read
std::vector<std::string> hints_of(const Assignment& assignment, const Task& task);

} // namespace rigor
