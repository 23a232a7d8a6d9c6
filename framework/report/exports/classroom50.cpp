// SPDX-License-Identifier: MIT
#include "report/exports/classroom50.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

struct Field {
    const char *name, *variable;
    const char* otherwise = ""; // the variable to read if `variable` is not set
};

// The fields of a result that the runner of Classroom 50 requires, and the environment variables
// that it sets for them. The runner corrects `owner`, `assignment_type` and `datetime` in the
// result, and refuses a result that lacks one of these fields.
constexpr std::array<Field, 8> required = {{{"classroom", "CLASSROOM"},
                                            {"assignment", "ASSIGNMENT"},
                                            {"assignment_type", "ASSIGNMENT_TYPE"},
                                            {"owner", "OWNER", "USERNAME"},
                                            {"submission", "SUBMISSION_TAG"},
                                            {"commit", "COMMIT_URL"},
                                            {"release", "RELEASE_URL"},
                                            {"review", "REVIEW_URL", "COMMIT_URL"}}};

Json points_of(const TaskResult& task)
{
    return {{"test-name", task.task.tag + " " + task.task.name()},
            {"passed", task.status == Status::passed},
            {"score", static_cast<int>(std::floor(task.score))},
            {"max-score", static_cast<int>(std::floor(task.max_score))}};
}

} // namespace

std::string classroom50_json(const Result& result, const Variable& variable, const std::string& now)
{
    if (result.status == SubmissionStatus::internal_error) return "";
    Json json = {{"schema", "classroom50/result/v1"}};
    for (const Field& field : required) {
        std::string value = variable(field.variable);
        if (value.empty()) value = variable(field.otherwise);
        if (value.empty()) return "";
        json[field.name] = value;
    }
    json["datetime"] = now;
    int score = 0, max_score = 0;
    Json tests = Json::array();
    for (const TaskResult& task : result.tasks) {
        if (task.max_score <= 0) continue;
        tests.push_back(points_of(task));
        score += tests.back()["score"].get<int>();
        max_score += tests.back()["max-score"].get<int>();
    }
    json["score"] = score;
    json["max-score"] = max_score;
    json["tests"] = tests;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace rigor
