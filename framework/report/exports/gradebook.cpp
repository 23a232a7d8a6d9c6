// SPDX-License-Identifier: MIT
#include "report/exports/gradebook.hpp"

#include "grading/intake/downloaded_name.hpp"
#include "report/csv.hpp"
#include "report/exports/listed_name.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <optional>

namespace rigor {

namespace {

std::string cell_of(const Row& row, double points)
{
    return row.has_points() ? csv_number(points) : "";
}

// The rows of the submissions that were judged, also of those that do not compile.
std::vector<const Row*> judged(const std::vector<Row>& rows)
{
    std::vector<const Row*> result;
    for (const Row& row : rows)
        if (row.is_judged()) result.push_back(&row);
    return result;
}

std::string counts_of_statuses(const std::vector<Row>& rows)
{
    constexpr std::array<std::pair<const char*, const char*>, 4> kinds = {
        {{"graded", "graded"},
         {"compile_error", "with compile errors"},
         {"rejected", "rejected"},
         {"internal_error", "not graded for a fault of the framework"}}};
    std::string text;
    for (const auto& kind : kinds) {
        const auto n = std::count_if(rows.begin(), rows.end(),
                                     [&](const Row& row) { return row.status == kind.first; });
        if (n > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, kind.second);
    }
    return text;
}

// What became of a task, as a column of the table.
enum class Fate { passed, failed, stub, not_defined, not_compiled, not_run };

Fate fate_of(const Row& row, std::size_t t)
{
    if (row.status == "compile_error") return Fate::not_compiled;
    const TaskPoints& task = row.tasks.at(t);
    if (task.status == "passed") return Fate::passed;
    if (task.status == "not_implemented") return Fate::stub;
    if (task.status == "compile_error") return Fate::not_defined;
    if (task.status == "skipped") return Fate::not_run;
    return Fate::failed;
}

constexpr const char* table_row = "{:<8}{:<32}{:>7}{:>7}{:>7}{:>13}{:>15}{:>9}\n";

std::string tasks_table(const std::vector<const Row*>& rows)
{
    std::string text = fmt::format(fmt::runtime(table_row), "task", "", "passed", "failed", "stub",
                                   "not defined", "compile error", "not run");
    for (std::size_t t = 0; t < rows.front()->tasks.size(); ++t) {
        std::map<Fate, int> n;
        for (const Row* row : rows)
            ++n[fate_of(*row, t)];
        const TaskPoints& task = rows.front()->tasks[t];
        text += fmt::format(fmt::runtime(table_row), task.tag, task.name, n[Fate::passed],
                            n[Fate::failed], n[Fate::stub], n[Fate::not_defined],
                            n[Fate::not_compiled], n[Fate::not_run]);
    }
    return text;
}

// The name of a student in a list: the name and the id that Canvas or Moodle has written into the
// name of the submission, or else the whole name of the submission. The id tells two students of
// the same name apart.
std::string listed_student(const Row& row)
{
    const std::optional<DownloadedName> name = downloaded_name(row.submission);
    return listed_name(name ? name->student() : row.submission);
}

// Names in lines of about 100 columns. Each line begins after `indent` columns; for the first line
// the caller writes these columns.
std::string wrapped(const std::vector<std::string>& names, std::size_t indent)
{
    constexpr std::size_t width = 100;
    std::string text;
    std::size_t column = indent;
    for (const std::string& name : names) {
        const bool is_first = text.empty();
        const bool is_too_long = !is_first && column + 2 + name.size() > width;
        text += is_first ? "" : is_too_long ? ",\n" + std::string(indent, ' ') : ", ";
        column = (is_too_long ? indent : column + (is_first ? 0 : 2)) + name.size();
        text += name;
    }
    return text;
}

// Who failed each task, or has not defined its function.
std::string failed_by_task(const std::vector<const Row*>& rows)
{
    std::string text;
    for (std::size_t t = 0; t < rows.front()->tasks.size(); ++t) {
        std::vector<std::string> names;
        for (const Row* row : rows) {
            const Fate fate = fate_of(*row, t);
            if (fate == Fate::failed) names.push_back(listed_student(*row));
            if (fate == Fate::not_defined) names.push_back(listed_student(*row) + " (not defined)");
        }
        if (!names.empty())
            text += fmt::format("  {:<8}{}\n", rows.front()->tasks[t].tag, wrapped(names, 10));
    }
    return text.empty() ? "" : "\nfailed:\n" + text;
}

// Why a submission has no points, by its tasks: "failed: 3, stub: 9".
std::string why_no_points(const Row& row)
{
    if (row.status == "compile_error") return "compile error";
    std::map<Fate, int> n;
    for (std::size_t t = 0; t < row.tasks.size(); ++t)
        ++n[fate_of(row, t)];
    std::string text;
    for (const auto& [fate, name] : {std::pair(Fate::failed, "failed"),
                                     {Fate::stub, "stub"},
                                     {Fate::not_defined, "not defined"},
                                     {Fate::not_run, "not run"},
                                     {Fate::passed, "without points"}}) // tasks worth 0 points
        if (n[fate] > 0) text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", name, n[fate]);
    return text.empty() ? "no tasks" : text;
}

// Who was judged and has no points.
std::string without_points(const std::vector<const Row*>& rows)
{
    std::vector<std::string> names;
    for (const Row* row : rows)
        if (row->points == 0)
            names.push_back(fmt::format("{} ({})", listed_student(*row), why_no_points(*row)));
    return names.empty() ? "" : "\n0 points:\n  " + wrapped(names, 2) + "\n";
}

std::string distribution(const std::vector<const Row*>& rows)
{
    std::vector<double> points;
    points.reserve(rows.size());
    for (const Row* row : rows)
        points.push_back(row->points);
    std::sort(points.begin(), points.end());
    double sum = 0;
    for (const double p : points)
        sum += p;
    const std::size_t n = points.size();
    const double median = (points[(n - 1) / 2] + points[n / 2]) / 2;
    const double most = rows.front()->max_points;
    std::string text =
        fmt::format("points, out of {:g}: lowest {:g}, median {:g}, mean {:.4g}, highest {:g}\n",
                    most, points.front(), median, sum / static_cast<double>(n), points.back());
    std::array<int, 10> tenths = {};
    for (const double p : points)
        ++tenths[most > 0 ? std::min(9, static_cast<int>(10 * p / most)) : 0];
    for (int i = 0; i < 10; ++i) {
        // A bar for all n submissions has 40 characters, and others are shorter in proportion.
        const int bar = static_cast<int>((40 * tenths[i] + static_cast<int>(n) - 1) / n);
        text += fmt::format("  {:>3} to {:>3} % {:>5}{}{}\n", 10 * i, 10 * (i + 1), tenths[i],
                            bar > 0 ? "  " : "", std::string(bar, '#'));
    }
    return text;
}

// The mistakes that several submissions have in common, the most frequent first.
std::string common_mistakes(const std::vector<const Row*>& rows)
{
    // How many submissions made a mistake. The key has the index of the task and the sentence.
    std::map<std::pair<std::size_t, std::string>, int> counts;
    for (const Row* row : rows)
        for (std::size_t t = 0; t < row->tasks.size(); ++t)
            if (!row->tasks[t].mistake.empty()) ++counts[{t, row->tasks[t].mistake}];
    std::vector<std::pair<int, std::string>> lines;
    for (const auto& [key, n] : counts)
        if (n > 1)
            lines.emplace_back(n, fmt::format("  {:>4}  {} {}\n", n,
                                              rows.front()->tasks[key.first].tag, key.second));
    std::stable_sort(lines.begin(), lines.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::string text;
    for (const auto& line : lines)
        text += line.second;
    return text.empty() ? ""
                        : "\nmistakes of several submissions, as their reports name them:\n" + text;
}

// The submissions of which no formula could be tested, each with the first line of its message.
std::string not_tested(const std::vector<Row>& rows)
{
    std::string text;
    for (const Row& row : rows)
        if (row.status != "graded") {
            const std::string why = row.message.substr(0, row.message.find('\n'));
            text += fmt::format("  {}: {}{}{}\n", listed_name(row.submission), row.status,
                                why.empty() ? "" : ": ", why);
        }
    return text.empty() ? "" : "\nwithout a grade by tests:\n" + text;
}

} // namespace

std::string gradebook_csv(const std::vector<Row>& rows)
{
    std::vector<std::string> cells = {"submission", "status", "points", "max"};
    if (!rows.empty())
        for (const TaskPoints& task : rows.front().tasks)
            cells.push_back(task.tag);
    std::string text = csv_line(cells);
    for (const Row& row : rows) {
        cells = {row.submission, row.status, cell_of(row, row.points), csv_number(row.max_points)};
        for (const TaskPoints& task : row.tasks)
            cells.push_back(cell_of(row, task.points));
        text += csv_line(cells);
    }
    return text;
}

std::string class_summary(const std::vector<Row>& rows)
{
    if (rows.empty()) return "no submissions\n";
    std::string text =
        fmt::format("{}: {} {}: {}\n", rows.front().assignment, rows.size(),
                    rows.size() == 1 ? "submission" : "submissions", counts_of_statuses(rows));
    const std::vector<const Row*> all = judged(rows);
    if (!all.empty())
        text += "\n" + tasks_table(all) + "\n" + distribution(all) + without_points(all) +
                failed_by_task(all) + common_mistakes(all);
    return text + not_tested(rows);
}

} // namespace rigor
