// SPDX-License-Identifier: MIT
#include "report/exports/learning_systems.hpp"

#include "grading/intake/downloaded_name.hpp"
#include "report/csv.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <set>

namespace rigor {

namespace {

bool has_grade(const Row& row)
{
    return row.status == "graded" || row.status == "compile_error";
}

// A status in words, such as "timed out".
std::string in_words(std::string status)
{
    if (status == "compile_error") return "not defined";
    std::replace(status.begin(), status.end(), '_', ' ');
    return status;
}

// A text about the tasks that did not get all points.
std::string feedback(const Row& row)
{
    if (row.status == "compile_error") return "no function can be called";
    std::string text;
    for (const TaskPoints& task : row.tasks)
        if (task.points < task.max_points)
            text += fmt::format("{}{} {} {:g}/{:g}", text.empty() ? "" : "; ", task.tag,
                                in_words(task.status), task.points, task.max_points);
    return text;
}

// What the name of a submission says, if this system gave it.
std::optional<DownloadedName> name_from(LearningSystem system, const Row& row)
{
    std::optional<DownloadedName> name = downloaded_name(row.submission);
    return name && name->system == system ? name : std::nullopt;
}

// The ids of the students with several graded submissions. From several lines for one student,
// Canvas and Moodle would take the points of the last one, which may not be the one that counts.
std::set<std::string> ambiguous(const std::vector<Row>& rows, LearningSystem system)
{
    std::set<std::string> once, several;
    for (const Row& row : rows)
        if (const auto name = name_from(system, row);
            has_grade(row) && name && !once.insert(name->number).second)
            several.insert(name->number);
    return several;
}

} // namespace

GradeFile canvas_grades(const std::vector<Row>& rows, const std::string& assignment_title)
{
    GradeFile file;
    file.csv =
        csv_line({"Student", "ID", "SIS User ID", "SIS Login ID", "Section", assignment_title});
    const std::set<std::string> several = ambiguous(rows, LearningSystem::canvas);
    const double possible = rows.empty() ? 0 : rows.front().max_points;
    file.csv += csv_line({"Points Possible", "", "", "", "", csv_number(possible)});
    for (const Row& row : rows) {
        if (!has_grade(row)) continue;
        const auto name = name_from(LearningSystem::canvas, row);
        if (name ? several.count(name->number) > 0 : downloaded_name(row.submission).has_value())
            continue;
        file.csv += csv_line({name ? name->name : row.submission, name ? name->number : "", "",
                              name ? "" : row.submission, "", csv_number(row.points)});
        ++file.submissions;
        if (!name) ++file.logins;
    }
    return file;
}

GradeFile moodle_grades(const std::vector<Row>& rows)
{
    GradeFile file;
    file.csv = csv_line({"Identifier", "Full name", "Grade", "Maximum Grade",
                         "Last modified (grade)", "Feedback comments"});
    const std::set<std::string> several = ambiguous(rows, LearningSystem::moodle);
    for (const Row& row : rows) {
        const auto name = name_from(LearningSystem::moodle, row);
        if (!has_grade(row) || !name || several.count(name->number) > 0) continue;
        file.csv += csv_line({"Participant " + name->number, name->name, csv_number(row.points),
                              csv_number(row.max_points), "", feedback(row)});
        ++file.submissions;
    }
    return file;
}

} // namespace rigor
