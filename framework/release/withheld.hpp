// SPDX-License-Identifier: MIT
// Which files of the engine give away the answer of a formula. A file does so if a student could
// get the points of a task by copying lines of the file. Lines that are also in the headers of
// framework/formulas do not count. A file that gives an answer away is replaced in the students'
// tree by one that calls the formula.
#pragma once

#include <span>
#include <string_view>

namespace rigor {

/// The decision on one file of the engine that computes the same as a formula, or nearly so.
struct JudgedFile {
    std::string_view path;  // relative to the top of the tree
    std::string_view tasks; // tags of the tasks whose formulas it is similar to
    std::string_view why;   // why it is replaced or kept
    /// The file whose text replaces its own in the students' tree; empty: the file is kept.
    std::string_view replacement;
};

/// All files of the engine that were judged. Files that only call formulas are not among them.
std::span<const JudgedFile> judged_files();

/// Visible tests that compute in plain arithmetic what a formula must return, and compare the
/// results. They are kept, since without them the task could not be checked; so the points of these
/// tasks say less about a student who reads the tests.
std::span<const JudgedFile> telling_tests();

/// The file whose text replaces that of `path` in the students' tree; empty if the file is kept.
std::string_view replacement_of(std::string_view path);

} // namespace rigor
