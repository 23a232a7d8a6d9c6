// SPDX-License-Identifier: MIT
// The corpus of hostile submissions of assignment A0: what each of them is, and what it may get.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rigor::corpus {

/// What may come of a submission.
struct Expectation {
    double points = 0;
    std::vector<std::string> statuses; // the submission's, or its only task's if it was graded
    std::string text;                  // a part of the message; empty for any
};

struct HostileSubmission {
    std::string name; // "kernel/socket"
    Expectation expected;
    /// Writes it below a folder. @return the folder or archive
    std::function<std::filesystem::path(const std::filesystem::path& folder)> write;
};

/// Sources, from tests/attacks/submissions/<kind>/<name>.cpp. A line of each says what to expect:
///
///     // expect: POINTS STATUS[|STATUS...][: a part of the message]
///
/// The headers beside a source go with it.
std::vector<HostileSubmission> hostile_sources(const std::filesystem::path& submissions);

/// Folders and archives that are hostile by their names or by what they hold.
/// @param solution  the text of a file that gets every point
std::vector<HostileSubmission> hostile_intakes(const std::string& solution);

} // namespace rigor::corpus
