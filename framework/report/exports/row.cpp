// SPDX-License-Identifier: MIT
#include "report/exports/row.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace rigor {

namespace {

std::string text_or_nothing(const nlohmann::json& json, const char* key)
{
    const auto found = json.find(key);
    return found == json.end() || found->is_null() ? "" : found->get<std::string>();
}

Row row_of(const nlohmann::json& json)
{
    Row row;
    row.submission = json.at("submission").get<std::string>();
    row.assignment = json.at("assignment").get<std::string>();
    row.status = json.at("status").get<std::string>();
    row.message = text_or_nothing(json, "message");
    row.fingerprint = text_or_nothing(json, "fingerprint");
    row.points = json.at("score").get<double>();
    row.max_points = json.at("max_score").get<double>();
    for (const nlohmann::json& task : json.at("tests"))
        row.tasks.push_back({task.at("tag").get<std::string>(), task.at("name").get<std::string>(),
                             task.at("status").get<std::string>(), task.at("score").get<double>(),
                             task.at("max_score").get<double>(), text_or_nothing(task, "mistake")});
    return row;
}

bool adds_up(const Row& row)
{
    double points = 0, max_points = 0;
    for (const TaskPoints& task : row.tasks) {
        if (!(task.points >= 0 && task.points <= task.max_points)) return false;
        points += task.points;
        max_points += task.max_points;
    }
    return !row.tasks.empty() && points == row.points && max_points == row.max_points;
}

} // namespace

std::optional<Row> read_row(const std::string& result_json)
{
    try {
        Row row = row_of(nlohmann::json::parse(result_json));
        if (adds_up(row)) return row;
    } catch (const nlohmann::json::exception&) {
        // the text is not the result of a submission
    }
    return {};
}

} // namespace rigor
