// SPDX-License-Identifier: MIT
#include "report/exports/learning_systems.hpp"

#include "report/exports/csv.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <regex>
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
    if (row.status == "compile_error") return "does not compile";
    std::string text;
    for (const TaskPoints& task : row.tasks)
        if (task.points < task.max_points)
            text += fmt::format("{}{} {} {:g}/{:g}", text.empty() ? "" : "; ", task.tag,
                                in_words(task.status), task.points, task.max_points);
    return text;
}

// The student's number in a name that Canvas or Moodle gave; empty for any other name.
std::string number_in(const std::string& submission, const std::regex& downloaded)
{
    std::smatch parts;
    return std::regex_match(submission, parts, downloaded) ? parts[2].str() : "";
}

// The numbers of the students with several graded submissions. Canvas and Moodle would take the
// points of the last one, which may not be the one that counts.
std::set<std::string> ambiguous(const std::vector<Row>& rows, const std::regex& downloaded)
{
    std::set<std::string> once, several;
    for (const Row& row : rows)
        if (const std::string number = number_in(row.submission, downloaded);
            has_grade(row) && !number.empty() && !once.insert(number).second)
            several.insert(number);
    return several;
}

// The names that Canvas and Moodle give to submissions when they are downloaded.
const std::regex& from_canvas()
{
    static const std::regex name("^([^_]+)_(?:LATE_)?([0-9]+)_[0-9]+(?:_.*)?$");
    return name;
}
const std::regex& from_moodle()
{
    static const std::regex name("^(.+)_([0-9]+)_assignsubmission_file(?:_.*)?$");
    return name;
}

} // namespace

std::string canvas_csv(const std::vector<Row>& rows, const std::string& assignment_title)
{
    const std::regex& downloaded = from_canvas();
    std::string text =
        csv_line({"Student", "ID", "SIS User ID", "SIS Login ID", "Section", assignment_title});
    const std::set<std::string> several = ambiguous(rows, downloaded);
    const double possible = rows.empty() ? 0 : rows.front().max_points;
    text += csv_line({"Points Possible", "", "", "", "", csv_number(possible)});
    for (const Row& row : rows) {
        if (!has_grade(row) || several.count(number_in(row.submission, downloaded)) > 0) continue;
        std::smatch parts;
        if (std::regex_match(row.submission, parts, downloaded))
            text += csv_line({parts[1], parts[2], "", "", "", csv_number(row.points)});
        else if (!std::regex_match(row.submission, from_moodle()))
            text += csv_line({row.submission, "", "", row.submission, "", csv_number(row.points)});
    }
    return text;
}

std::string moodle_csv(const std::vector<Row>& rows)
{
    const std::regex& downloaded = from_moodle();
    std::string text = csv_line({"Identifier", "Full name", "Grade", "Maximum Grade",
                                 "Last modified (grade)", "Feedback comments"});
    const std::set<std::string> several = ambiguous(rows, downloaded);
    for (const Row& row : rows) {
        std::smatch parts;
        if (!has_grade(row) || !std::regex_match(row.submission, parts, downloaded) ||
            several.count(parts[2]) > 0)
            continue;
        text += csv_line({"Participant " + parts[2].str(), parts[1], csv_number(row.points),
                          csv_number(row.max_points), "", feedback(row)});
    }
    return text;
}

} // namespace rigor
