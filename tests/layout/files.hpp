// SPDX-License-Identifier: MIT
// The text files of the tree, by their kind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor::layout {

/// A text file of the tree.
struct File {
    std::filesystem::path path; ///< from the top of the tree
    std::vector<std::string> lines;
};

using Files = std::vector<File>;

/// The C++ files of framework, student, reference and tests, in the order of their names.
Files sources(const std::filesystem::path& top);

/// Files that have comments but are not C++: CMake files, shell scripts and the script `rigor`.
Files scripts(const std::filesystem::path& top);

/// The Markdown files, also those outside the folders of sources.
Files texts(const std::filesystem::path& top);

} // namespace rigor::layout
