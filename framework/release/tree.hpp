// SPDX-License-Identifier: MIT
// What is handed out: the files of the students' tree, and of the tree that an autograder needs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// A file as it is handed out.
struct ReleasedFile {
    std::string path; // in the tree, such as "framework/formulas/inertia.hpp"
    std::string content;
    bool is_executable = false;
};

using ReleasedTree = std::vector<ReleasedFile>; // sorted by path

/// The students' tree: framework, stubs, handouts, scenes and visible tests. It lacks the
/// reference, hidden tests, mistakes, alternatives, attacks, the instructor's pages and what gives
/// an answer away (withheld.hpp). In a git repository only tracked files are taken, with the
/// content that they have in the folder now.
/// @throws InputError if a formula in student/ is not the untouched stub
ReleasedTree students_tree(const std::filesystem::path& source);

/// The tree for an autograder: the students' tree with the reference, with the hidden tests, and
/// with the original files of the engine, not their replacements (withheld.hpp). It has student/
/// as it is now, because an earlier topic may be solved there.
ReleasedTree grading_tree(const std::filesystem::path& source);

/// @throws InputError if git is not installed
void require_git();

/// The content of a file. @throws InputError if it cannot be read
std::string file_content(const std::filesystem::path& file);

/// Adds a file at its place in the order of paths.
void add_file(ReleasedTree& tree, ReleasedFile file);

/// Writes the files of the tree to a folder. Files that have the same content already are not
/// written again. All other files are removed, except those in `keep`, the relative path of a
/// folder inside.
/// @throws InputError if a file cannot be written
void write_tree(const ReleasedTree& tree, const std::filesystem::path& folder,
                const std::string& keep = "");

} // namespace rigor
