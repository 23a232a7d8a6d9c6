// SPDX-License-Identifier: MIT
// A row of the gradebook, read back from a result.json. The gradebook is made from the files and
// never from what is in memory, so it is the same whether results are new or were there before.
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

    /// Whether it has points: a fault of the framework gives none, not even zero.
    bool has_points() const { return status != "internal_error"; }
};

/// The row of a result.json. Nothing if the text is not the whole result of one submission: a task
/// without points, or points that are not the sum of those of the tasks.
std::optional<Row> read_row(const std::string& result_json);

} // namespace rigor
