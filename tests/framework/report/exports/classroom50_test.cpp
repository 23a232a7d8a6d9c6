// SPDX-License-Identifier: MIT
// The rules are those that Classroom 50 publishes as `result-v1.schema.json`, and that its
// `runner.py` and `collect_scores.py` check besides.
#include "report/exports/classroom50.hpp"

#include "framework/report/results.hpp"
#include "support/catch.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

namespace rigor::testing::classroom50_test {

namespace {

using nlohmann::json;

const std::map<std::string, std::string> variables = {
    {"CLASSROOM", "animation"},
    {"ASSIGNMENT", "a2"},
    {"SUBMISSION_TAG", "submit/2026-06-01T14-32-05Z-a1b2c3d"},
    {"COMMIT_URL", "https://example.org/commit/1"},
    {"RELEASE_URL", "https://example.org/releases/1"},
    {"OWNER", "alice"},
    {"ASSIGNMENT_TYPE", "individual"}};

std::string exported(const Result& result, const std::string& without = "")
{
    const auto value = [&](const char* name) {
        const auto found = variables.find(name);
        return found == variables.end() || name == without ? "" : found->second;
    };
    return classroom50_json(result, value, "2026-06-01T14:33:11Z");
}

void require_valid_points(const json& object)
{
    for (const char* name : {"score", "max-score"}) {
        REQUIRE(object.at(name).is_number_integer());
        REQUIRE(object.at(name) >= 0);
    }
    REQUIRE(object.at("score") <= object.at("max-score"));
}

void require_valid(const json& result)
{
    const std::set<std::string> texts = {"classroom", "assignment", "owner",  "submission",
                                         "commit",    "release",    "review", "datetime"};
    REQUIRE(result.at("schema") == "classroom50/result/v1");
    for (const std::string& name : texts)
        REQUIRE_FALSE(result.at(name).get<std::string>().empty());
    const std::set<std::string> types = {"individual", "group", "team"};
    REQUIRE(types.count(result.at("assignment_type").get<std::string>()) == 1);
    for (const auto& [name, value] : result.items()) { // no other field is allowed
        CAPTURE(name);
        REQUIRE((texts.count(name) == 1 || name == "schema" || name == "assignment_type" ||
                 name == "score" || name == "max-score" || name == "tests"));
    }
    REQUIRE(result.at("submission").get<std::string>().starts_with("submit/"));
    REQUIRE(
        std::regex_match(result.at("datetime").get<std::string>(),
                         std::regex("\\d{4}-\\d\\d-\\d\\dT([01]\\d|2[0-3]):[0-5]\\d:[0-5]\\dZ")));
    require_valid_points(result);
    int score = 0, max_score = 0;
    for (const json& test : result.at("tests")) {
        REQUIRE_FALSE(test.at("test-name").get<std::string>().empty());
        REQUIRE(test.at("passed").is_boolean());
        require_valid_points(test);
        score += test.at("score").get<int>();
        max_score += test.at("max-score").get<int>();
    }
    REQUIRE(result.at("score") == score);
    REQUIRE(result.at("max-score") == max_score);
}

} // namespace

TEST_CASE("classroom 50: a result keeps the published rules", "[report]")
{
    Result result = some_result();
    result.tasks[1].score = 0.5; // a part of a point: Classroom 50 knows whole points only
    const json written = json::parse(exported(result));
    require_valid(written);
    CHECK(written["classroom"] == "animation");
    CHECK(written["assignment"] == "a2");
    CHECK(written["owner"] == "alice");
    CHECK(written["review"] == written["commit"]);
    CHECK(written["score"] == 2);
    CHECK(written["max-score"] == 8);
    REQUIRE(written["tests"].size() == 4);
    CHECK(written["tests"][0]["passed"] == true);
    CHECK(written["tests"][1]["score"] == 0);
}

TEST_CASE("classroom 50: there is no file outside of its runner or for a fault of ours", "[report]")
{
    Result result = some_result();
    for (const char* name : {"CLASSROOM", "ASSIGNMENT", "ASSIGNMENT_TYPE", "OWNER",
                             "SUBMISSION_TAG", "COMMIT_URL", "RELEASE_URL"})
        CHECK(exported(result, name).empty());
    result.status = SubmissionStatus::internal_error;
    CHECK(exported(result).empty());
    result.status = SubmissionStatus::rejected;
    require_valid(json::parse(exported(result)));
}

} // namespace rigor::testing::classroom50_test
