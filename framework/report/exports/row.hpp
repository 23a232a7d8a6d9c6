// SPDX-License-Identifier: MIT
// A row of the gradebook, read back from a result.json. The gradebook is always made from these
// files, never from results in memory, so new results and those that were kept from an
// earlier run are treated in the same way.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rigor {

struct TaskPoints {
    std::string tag, name;
    std::string status; // "passed", "failed", …
    double points = 0, max_points = 0;
    std::string mistake = {}; // why the answers are wrong; empty if it is not known
};

struct Row {
    std::string submission;
    std::string status;  // "graded", "rejected", …
    std::string message; // explains a status other than "graded"
    std::string assignment;
    std::string fingerprint;
    double points = 0, max_points = 0;
    std::vector<TaskPoints> tasks;

    /// Whether the submission has points: a fault of the framework gives none, not even zero.
    bool has_points() const { return status != "internal_error"; }
    /// Whether the submission was judged, also if it does not compile.
    bool is_judged() const { return status == "graded" || status == "compile_error"; }
};

/// The row of a result.json. Empty if the text is not the complete result of one submission, or if
/// the points of its tasks do not add up to the points of the submission.
std::optional<Row> read_row(const std::string& result_json);

} // namespace rigor
