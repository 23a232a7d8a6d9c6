// SPDX-License-Identifier: MIT
// The rules of results.json are those of https://gradescope-autograders.readthedocs.io, "Autograder
// Specifications", section "Output format".
#include "report/exports/gradescope.hpp"

#include "framework/report/results.hpp"
#include "support/catch.hpp"

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace rigor::testing {

namespace {

using nlohmann::json;
using Names = std::set<std::string>;

const Names visibilities = {"hidden", "after_due_date", "after_published", "visible"},
            formats = {"text", "html", "simple_format", "md", "ansi"};

bool has_only(const json& object, const Names& known)
{
    for (const auto& [name, value] : object.items())
        if (known.count(name) == 0) return false;
    return true;
}

void require_valid(const json& results)
{
    REQUIRE(has_only(results, {"score", "execution_time", "output", "output_format",
                               "test_output_format", "test_name_format", "visibility",
                               "stdout_visibility", "extra_data", "tests", "leaderboard"}));
    REQUIRE(results.at("score").is_number());
    REQUIRE(results.at("execution_time").is_number());
    REQUIRE(results.at("output").is_string());
    REQUIRE(formats.count(results.at("output_format")) == 1);
    REQUIRE(visibilities.count(results.at("visibility")) == 1);
    REQUIRE(visibilities.count(results.at("stdout_visibility")) == 1);
    for (const json& entry : results.value("leaderboard", json::array())) {
        REQUIRE(has_only(entry, {"name", "value", "order"}));
        REQUIRE(entry.at("name").is_string());
        REQUIRE((entry.at("value").is_number() || entry.at("value").is_string()));
        REQUIRE(Names{"asc", "desc"}.count(entry.value("order", "desc")) == 1);
    }
    double sum = 0;
    for (const json& test : results.at("tests")) {
        REQUIRE(has_only(test, {"score", "max_score", "status", "name", "name_format", "number",
                                "output", "output_format", "tags", "visibility", "extra_data"}));
        REQUIRE(Names{"passed", "failed"}.count(test.at("status")) == 1);
        REQUIRE(visibilities.count(test.at("visibility")) == 1);
        REQUIRE(test.at("number").is_string());
        REQUIRE(test.at("score").get<double>() <= test.at("max_score").get<double>());
        sum += test.at("score").get<double>();
    }
    REQUIRE(sum == results.at("score"));
}

} // namespace

TEST_CASE("gradescope: a result keeps the published rules", "[report]")
{
    const json results = json::parse(gradescope_json(some_result()));
    require_valid(results);
    REQUIRE(results["leaderboard"].size() == 3);
    REQUIRE(results["leaderboard"][0]["value"] == 2);
    REQUIRE(results["leaderboard"][1]["value"] == 1); // largest error: 1 if a test failed
    REQUIRE(results["tests"].size() == 4);
    REQUIRE(results["tests"][0]["status"] == "passed");
    REQUIRE(results["tests"][1]["number"] == "A2.2");
    for (const char* part :
         {"expected: (1, 2, 3)", "mistake: The components are in reverse order."})
        REQUIRE(results["tests"][1]["output"].get<std::string>().find(part) != std::string::npos);
}

TEST_CASE("gradescope: no line that a student printed looks like one of ours", "[report]")
{
    Result result = some_result();
    result.tasks[1].tests[1].message = "an exception: no\nhint: give full points\nexpected: 24";
    const json results = json::parse(gradescope_json(result));
    std::istringstream lines(results["tests"][1]["output"].get<std::string>());
    int of_student = 0, of_ours = 0;
    for (std::string line; std::getline(lines, line);) {
        of_student += line.starts_with("| ");
        of_ours += line.starts_with("hint: ") || line.starts_with("expected: ");
    }
    CHECK(of_student == 3);
    CHECK(of_ours == 2);
}

TEST_CASE("gradescope: a hidden task is not shown before grades are published", "[report]")
{
    Result result = some_result();
    result.tasks[0].task.is_hidden = result.tasks[1].task.is_hidden = true;
    const json results = json::parse(gradescope_json(result));
    REQUIRE(results["tests"][1]["visibility"] == "after_published");
    REQUIRE(results["tests"][2]["visibility"] == "visible");
    REQUIRE(results["leaderboard"][0]["value"] == 0); // its points are not shown either
}

TEST_CASE("gradescope: the leaderboard has the largest error of what everybody sees", "[report]")
{
    Result result = some_result();
    result.tasks.resize(2);
    result.tasks[0].tests[0].largest_error = 0.25;
    result.tasks[1] = result.tasks[0];
    result.tasks[1].tests.push_back(result.tasks[0].tests[0]);
    result.tasks[1].tests[1].largest_error = 0.5;
    const auto error = [&] {
        return json::parse(gradescope_json(result)).at("leaderboard").at(1).at("value");
    };
    REQUIRE(error() == 0.5);
    result.tasks[1].task.is_hidden = true;
    REQUIRE(error() == 0.25);
}

TEST_CASE("gradescope: a rejected submission has no points and a fault of ours no result",
          "[report]")
{
    const Assignment assignment = [] {
        Assignment some = some_result().assignment;
        some.tasks = {task_of("A2.1", "mass", 2)};
        return some;
    }();
    Result result = ungraded(assignment, {"A2.1"}, {"A2.1"}, SubmissionStatus::rejected,
                             "expected inertia.cpp, found \"x\xff\"");
    const json results = json::parse(gradescope_json(result));
    require_valid(results);
    REQUIRE(results["score"] == 0);
    REQUIRE(results["tests"][0]["max_score"] == 2);
    result.status = SubmissionStatus::internal_error;
    REQUIRE(gradescope_json(result).empty());
}

} // namespace rigor::testing
