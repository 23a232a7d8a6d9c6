// SPDX-License-Identifier: MIT
#include "report/result_json.hpp"

#include <nlohmann/json.hpp>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::string& text)
{
    return text.empty() ? Json(nullptr) : Json(text);
}

Json case_json(const TestCase& test)
{
    return {{"name", test.name},
            {"status", to_string(test.status)},
            {"visibility", test.is_hidden ? "hidden" : "visible"},
            {"message", text_or_null(test.message)},
            {"seconds", test.seconds}};
}

Json task_json(const TaskResult& result)
{
    const TestCase* failure = result.first_failure();
    const TestCase shown = failure ? *failure : TestCase();
    const bool did_not_run = result.tests.empty();
    Json cases = Json::array();
    for (const TestCase& test : result.tests)
        cases.push_back(case_json(test));
    return {
        {"tag", result.task.tag},
        {"name", result.task.name()},
        {"status", to_string(result.status)},
        {"score", result.score},
        {"max_score", result.max_score},
        {"follow_through", result.follow_through},
        {"visibility", result.task.is_hidden ? "hidden" : "visible"},
        {"message", did_not_run ? Json("did not run") : text_or_null(failure ? failure->name : "")},
        {"detail", text_or_null(shown.message)},
        {"mistake", text_or_null(result.mistake())},
        {"expected", text_or_null(shown.expected)},
        {"actual", text_or_null(shown.actual)},
        {"error", text_or_null(shown.error)},
        {"tolerance", text_or_null(shown.tolerance)},
        {"tolerance_class", text_or_null(shown.tolerance_class)},
        {"place", text_or_null(shown.place)},
        {"seed", shown.seed ? Json(*shown.seed) : Json(nullptr)},
        {"hint",
         failure ? Json(shown.hint.empty() ? result.task.hint : shown.hint) : Json(nullptr)},
        {"cases", cases}};
}

Json result_json(const Result& result)
{
    Json tests = Json::array();
    for (const TaskResult& task : result.tasks)
        tests.push_back(task_json(task));
    Json json = {{"assignment", result.assignment.name},
                 {"submission", result.submission},
                 {"status", to_string(result.status)},
                 {"message", text_or_null(result.message)},
                 {"score", result.score()},
                 {"max_score", result.max_score()},
                 {"seed", result.seed},
                 {"seeds", result.has_secret_seeds ? "drawn by a secret" : "the same for all"},
                 {"tests", tests},
                 {"walls", text_or_null(result.walls)},
                 {"timing",
                  {{"build_seconds", result.build_seconds}, {"test_seconds", result.test_seconds}}},
                 {"versions", {{"rigor", RIGOR_VERSION}, {"compiler", RIGOR_COMPILER}}}};
    if (!result.notes.empty()) json["notes"] = result.notes;
    if (!result.fingerprint.empty()) json["fingerprint"] = result.fingerprint;
    return json;
}

} // namespace

std::string to_json(const std::vector<Result>& results)
{
    Json value = Json::array();
    for (const Result& result : results)
        value.push_back(result_json(result));
    if (results.size() == 1) value = Json(value[0]);
    return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace rigor
