// SPDX-License-Identifier: MIT
#include "report/exports/changes.hpp"

#include "report/exports/listed_name.hpp"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>

namespace rigor {

namespace {

std::string points_in_words(const Row& row)
{
    const std::string points = fmt::format("{:g}/{:g} points", row.points, row.max_points);
    if (row.status == "graded") return points;
    return row.has_points() ? row.status + ", " + points : row.status;
}

std::string points_in_words(const TaskPoints& task)
{
    return fmt::format("{} {:g}/{:g}", task.status, task.points, task.max_points);
}

std::string tasks_that_change(const Row& before, const Row& after)
{
    std::string text;
    for (const TaskPoints& task : after.tasks) {
        const auto same = std::find_if(before.tasks.begin(), before.tasks.end(),
                                       [&](const TaskPoints& old) { return old.tag == task.tag; });
        if (same == before.tasks.end())
            text += fmt::format("    {} {}: new, {}\n", task.tag, task.name, points_in_words(task));
        else if (same->points != task.points || same->max_points != task.max_points)
            text += fmt::format("    {} {}: {} → {}\n", task.tag, task.name, points_in_words(*same),
                                points_in_words(task));
    }
    for (const TaskPoints& old : before.tasks)
        if (std::none_of(after.tasks.begin(), after.tasks.end(),
                         [&](const TaskPoints& task) { return old.tag == task.tag; }))
            text += fmt::format("    {} {}: {} → no task any more\n", old.tag, old.name,
                                points_in_words(old));
    return text;
}

// Whether a submission has the same status and the same points in each task as before. The maxima
// may differ.
bool keeps_points(const std::optional<Row>& before, const Row& after)
{
    return before && before->status == after.status &&
           std::equal(before->tasks.begin(), before->tasks.end(), after.tasks.begin(),
                      after.tasks.end(), [](const TaskPoints& old, const TaskPoints& task) {
                          return old.tag == task.tag && old.points == task.points;
                      });
}

// The mean of the points as a text; "none" if the list is empty.
std::string mean(const std::vector<double>& points)
{
    double sum = 0;
    for (const double one : points)
        sum += one;
    return points.empty() ? "none"
                          : fmt::format("{:.2f}", sum / static_cast<double>(points.size()));
}

} // namespace

std::string change_text(const std::optional<Row>& before, const Row& after)
{
    const std::string name = listed_name(after.submission);
    if (!before) return fmt::format("  {}: new, {}\n", name, points_in_words(after));
    const std::string tasks = tasks_that_change(*before, after);
    if (before->status == after.status && tasks.empty()) return "";
    return fmt::format("  {}: {} → {}\n", name, points_in_words(*before), points_in_words(after)) +
           tasks;
}

std::string changes_text(const std::vector<std::optional<Row>>& before,
                         const std::vector<Row>& after)
{
    assert(before.size() == after.size());
    std::string text;
    std::size_t changed = 0, kept = 0;
    std::vector<double> old_points, new_points;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const std::string change = change_text(before[i], after[i]);
        if (!change.empty() && keeps_points(before[i], after[i])) {
            ++kept;
        } else {
            changed += !change.empty();
            text += change;
        }
        // the mean of those that were judged, as in the summary of the class
        if (before[i] && before[i]->is_judged()) old_points.push_back(before[i]->points);
        if (after[i].is_judged()) new_points.push_back(after[i].points);
    }
    const std::string same = kept == 0 ? "" : fmt::format(" and {} only in the maximum", kept);
    return text + fmt::format("{} of {} submissions {}{}; the mean of the points: {} → {}\n",
                              changed, after.size(), changed == 1 ? "changes" : "change", same,
                              mean(old_points), mean(new_points));
}

} // namespace rigor
