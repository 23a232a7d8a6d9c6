// SPDX-License-Identifier: MIT
#include "report/exports/gradescope.hpp"

#include "errors/quotes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

std::string output_of(const TaskResult& task)
{
    const TestCase* failure = task.first_failure();
    if (task.status == Status::passed)
        return task.follow_through ? "passed, with the reference in place of what it builds on"
                                   : "passed";
    if (!failure) return "did not run";
    std::string text = fmt::format("{}: {}", to_string(task.status),
                                   failure->name.empty() ? task.task.name() : failure->name);
    // A student's code may throw any text, also one that looks like the lines below.
    if (!failure->message.empty()) text += "\n" + behind_bars(failure->message);
    if (!failure->expected.empty())
        text += "\nexpected: " + failure->expected + "\nactual:   " + failure->actual;
    if (const std::string mistake = task.mistake(); !mistake.empty())
        text += "\nmistake: " + mistake;
    const std::string& hint = failure->hint.empty() ? task.task.hint : failure->hint;
    return hint.empty() ? text : text + "\nhint: " + hint;
}

Json test_of(const TaskResult& task)
{
    return {{"score", task.score},
            {"max_score", task.max_score},
            {"status", task.status == Status::passed ? "passed" : "failed"},
            {"name", task.task.name()},
            {"number", task.task.tag},
            {"output", output_of(task)},
            {"visibility", task.task.is_hidden ? "after_published" : "visible"}};
}

std::string output_of(const Result& result)
{
    std::string text = fmt::format("{}: {}", result.assignment.title, to_string(result.status));
    if (!result.message.empty()) text += "\n" + result.message;
    for (const std::string& note : result.notes)
        text += "\n" + note;
    return text;
}

// The largest error / tolerance of a task's tests; 1 if one of the tests did not pass.
double largest_error_of(const TaskResult& task)
{
    if (task.status != Status::passed) return 1;
    double largest = 0;
    for (const TestCase& test : task.tests)
        largest = std::max(largest, test.largest_error);
    return largest;
}

// The leaderboard of Gradescope: points, largest error, and run time. Everybody sees it, so its
// points and its error are those of the visible tasks.
Json leaderboard_of(const Result& result)
{
    double points = 0, error = 0;
    for (const TaskResult& task : result.tasks) {
        if (task.task.is_hidden || task.max_score <= 0) continue;
        points += task.score;
        error = std::max(error, largest_error_of(task));
    }
    return {{{"name", "points of visible tasks"}, {"value", points}},
            {{"name", "largest error, in tolerances"}, {"value", error}, {"order", "asc"}},
            {{"name", "time of the tests [s]"}, {"value", result.test_seconds}, {"order", "asc"}}};
}

} // namespace

std::string gradescope_json(const Result& result)
{
    if (result.status == SubmissionStatus::internal_error) return "";
    Json tests = Json::array();
    for (const TaskResult& task : result.tasks)
        if (task.max_score > 0) tests.push_back(test_of(task));
    Json json = {{"score", result.score()},
                 {"execution_time", result.build_seconds + result.test_seconds},
                 {"output", output_of(result)},
                 {"output_format", "text"},
                 {"test_output_format", "text"},
                 {"visibility", "visible"},
                 {"stdout_visibility", "hidden"},
                 {"tests", tests}};
    if (result.status == SubmissionStatus::graded) json["leaderboard"] = leaderboard_of(result);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace rigor
