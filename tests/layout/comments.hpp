// SPDX-License-Identifier: MIT
// The comments of C++ files. Slashes in strings begin no comment.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::layout {

/// A comment in a line of a file, from its slashes to the end of the line.
struct Comment {
    std::size_t line; ///< counted from 1
    bool is_trailing; ///< code stands before it
    std::string text; ///< without the slashes and the spaces after them
};

/// The comments that begin with two slashes.
std::vector<Comment> comments(const std::vector<std::string>& lines);

/// Number of characters of a line in UTF-8, each one column wide.
std::size_t width(std::string_view line);

} // namespace rigor::layout
