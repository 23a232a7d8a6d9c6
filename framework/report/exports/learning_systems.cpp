// SPDX-License-Identifier: MIT
#include "report/exports/learning_systems.hpp"

#include "report/exports/csv.hpp"

#include <fmt/format.h>
#include <regex>

namespace rigor {

namespace {

bool has_grade(const Row& row)
{
    return row.status == "graded" || row.status == "compile_error";
}

// The tasks that did not get all points.
std::string feedback(const Row& row)
{
    if (row.status == "compile_error") return "does not compile";
    std::string text;
    for (const TaskPoints& task : row.tasks)
        if (task.points < task.max_points)
            text += fmt::format("{}{} {} {:g}/{:g}", text.empty() ? "" : "; ", task.tag,
                                task.status, task.points, task.max_points);
    return text;
}

} // namespace

std::string canvas_csv(const std::vector<Row>& rows, const std::string& assignment_title)
{
    static const std::regex downloaded("^([^_]+)_(?:LATE_)?([0-9]+)_[0-9]+(?:_.*)?$");
    std::string text =
        csv_line({"Student", "ID", "SIS User ID", "SIS Login ID", "Section", assignment_title});
    const double possible = rows.empty() ? 0 : rows.front().max_points;
    text += csv_line({"Points Possible", "", "", "", "", csv_number(possible)});
    for (const Row& row : rows) {
        if (!has_grade(row)) continue;
        std::smatch parts;
        if (std::regex_match(row.submission, parts, downloaded))
            text += csv_line({parts[1], parts[2], "", "", "", csv_number(row.points)});
        else
            text += csv_line({row.submission, "", "", row.submission, "", csv_number(row.points)});
    }
    return text;
}

std::string moodle_csv(const std::vector<Row>& rows)
{
    static const std::regex downloaded("^(.+)_([0-9]+)_assignsubmission_file_?$");
    std::string text = csv_line({"Identifier", "Full name", "Grade", "Maximum Grade",
                                 "Last modified (grade)", "Feedback comments"});
    for (const Row& row : rows) {
        std::smatch parts;
        if (!has_grade(row) || !std::regex_match(row.submission, parts, downloaded)) continue;
        text += csv_line({"Participant " + parts[2].str(), parts[1], csv_number(row.points),
                          csv_number(row.max_points), "", feedback(row)});
    }
    return text;
}

} // namespace rigor
