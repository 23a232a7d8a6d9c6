// SPDX-License-Identifier: MIT
#pragma once

#include "grading/assignment.hpp"

#include <string>
#include <vector>

namespace rigor {

/// An assignment and the tags of the tasks that were selected from it.
struct Selection {
    Assignment assignment;
    std::vector<std::string> tags;
};

/// The tasks that the words name. A word is an assignment (`a2-inertia`, `A2`), its topic
/// (`inertia`), a task's tag (`A2.14`) or its formula (`combine`), in upper or lower case. Without
/// words, all tasks are selected.
/// @throws InputError if a word names nothing; its message suggests the nearest name
std::vector<Selection> select_tasks(const std::vector<Assignment>& assignments,
                                    const std::vector<std::string>& words);

} // namespace rigor
