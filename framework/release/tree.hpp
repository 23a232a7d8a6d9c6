// SPDX-License-Identifier: MIT
// What is handed out: the files of the students' tree, and of the tree that an autograder needs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// A file as it is handed out.
struct ReleasedFile {
    std::string path; // "framework/formulas/inertia.hpp"
    std::string content;
    bool is_executable = false;
};

using ReleasedTree = std::vector<ReleasedFile>; // sorted by path

/// The students' tree: framework, stubs, handouts, scenes and visible tests. It lacks the
/// reference, hidden tests, mistakes, alternatives, attacks, the instructor's page and what gives
/// an answer away (withheld.hpp). In a git repository only files under its control are taken, with
/// the content that they have now.
/// @throws InputError if a stub in student/ is not the untouched one
ReleasedTree students_tree(const std::filesystem::path& source);

/// The tree that grades: the students' tree with the reference, the hidden tests and the engine's
/// own files, and with what student/ has now, for formulas of earlier topics.
ReleasedTree grading_tree(const std::filesystem::path& source);

/// @throws InputError if git is not installed
void require_git();

/// The content of a file. @throws InputError if it cannot be read
std::string file_content(const std::filesystem::path& file);

/// Adds a file and keeps the order.
void add_file(ReleasedTree& tree, ReleasedFile file);

/// Makes a folder have the files of the tree. Files that are there already with the same content
/// are not written again; other files are removed, but `keep`, a folder at its top.
/// @throws InputError if a file cannot be written
void write_tree(const ReleasedTree& tree, const std::filesystem::path& folder,
                const std::string& keep = "");

} // namespace rigor
