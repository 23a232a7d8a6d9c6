// SPDX-License-Identifier: MIT
// Files for services that grade submissions: an autograder for Gradescope, and a workflow for a
// repository on GitHub.
#pragma once

#include "grading/assignment.hpp"
#include "release/tree.hpp"

#include <filesystem>
#include <string>

namespace rigor {

/// The files of a Gradescope autograder, as they lie in its zip: `setup.sh`, which Gradescope runs
/// once as root, `run_autograder`, which it runs for each submission, and in `rigor/` the tree that
/// grades. Where the assignment needs an earlier topic of which student/ has only stubs
/// (`called_stubs`), the tree has the reference's file.
///
/// @param secret  draws the random cases of each submission and is in the zip; empty: all
///                submissions get the same cases
ReleasedTree gradescope_tree(const std::filesystem::path& source, const Assignment& assignment,
                             const std::string& secret);

/// The path of the workflow in a template repository for GitHub Classroom.
inline constexpr const char* workflow_path = ".github/workflows/classroom.yml";

/// The workflow that checks a student's repository at each push: a step for each visible task, by
/// the command grader of GitHub Classroom, and a step that reports the points. The names of the
/// workflow and of its job are those that GitHub Classroom looks for.
std::string classroom_workflow(const Assignment& assignment);

} // namespace rigor
