// SPDX-License-Identifier: MIT
// The rules of the tree that no compiler checks. CONTRIBUTING.md gives their reasons.
#pragma once

#include "layout/files.hpp"

#include <string>
#include <vector>

namespace rigor::layout {

/// A file, or a folder, that breaks a rule.
struct Violation {
    std::string place; ///< from the top of the tree, with the line if there is one
    std::string rule;
};

using Violations = std::vector<Violation>;

// Each rule by itself.
Violations large_folders(const Files& sources);
Violations including_each_other(const Files& sources);
Violations sources_without_header(const Files& sources);
Violations misplaced_tests(const Files& sources);
Violations wide_comments(const Files& sources);
Violations wide_script_comments(const Files& scripts);
Violations wide_prose(const Files& texts);
Violations lines_that_begin_with_of(const Files& sources);
Violations graded_checks_without_words(const Files& sources);
Violations missing_first_lines(const Files& sources);

/// Checks all rules. A tree without sources or without texts breaks a rule, too.
Violations check_tree(const std::filesystem::path& top);

} // namespace rigor::layout
