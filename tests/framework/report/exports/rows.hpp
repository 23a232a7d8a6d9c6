// SPDX-License-Identifier: MIT
// A small class to report.
#pragma once

#include "report/exports/row.hpp"

namespace rigor::testing {

inline Row row_of(const std::string& name, const std::string& status, double first, double second)
{
    Row row;
    row.submission = name;
    row.status = status;
    row.assignment = "a2-inertia";
    row.points = first + second;
    row.max_points = 5;
    row.tasks = {{"A2.1", "mass", first > 0 ? "passed" : "failed", first, 2},
                 {"A2.2", "turn", second > 0 ? "passed" : "not_implemented", second, 3}};
    return row;
}

/// A submission with all points, one with some, and three that no test has judged: a fault of the
/// framework, a rejected submission, and one that does not compile.
inline std::vector<Row> some_class()
{
    std::vector<Row> rows = {row_of("Doe, Jane_17_assignsubmission_file", "graded", 2, 3),
                             row_of("doejohn_LATE_4711_99_a2.zip", "graded", 2, 0),
                             row_of("eve", "internal_error", 0, 0),
                             row_of("mallory", "rejected", 0, 0),
                             row_of("zed", "compile_error", 0, 0)};
    rows[2].message = "the test program died";
    rows[3].message = "expected inertia.cpp, found no file";
    for (TaskPoints& task : rows[4].tasks)
        task.status = "skipped"; // nothing of it could be tested
    return rows;
}

} // namespace rigor::testing
