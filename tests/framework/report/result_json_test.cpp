// SPDX-License-Identifier: MIT
#include "report/result_json.hpp"
#include "results.hpp"
#include "scene/description/scene.hpp"
#include "support/catch.hpp"

#include <nlohmann/json.hpp>

namespace rigor::testing {

TEST_CASE("report: result.json has what the other formats need", "[report]")
{
    const nlohmann::json value = nlohmann::json::parse(to_json({some_result()}));
    REQUIRE(value["assignment"] == "a2-inertia");
    REQUIRE(value["submission"] == "student");
    REQUIRE(value["status"] == "graded");
    REQUIRE(value["score"] == 2);
    REQUIRE(value["max_score"] == 8);
    REQUIRE(value.contains("seed"));
    REQUIRE(value["timing"].contains("test_seconds"));
    REQUIRE(value["versions"].contains("compiler"));
    const nlohmann::json& failed = value["tests"][1];
    for (const char* key : {"tag", "name", "status", "score", "max_score", "visibility", "message",
                            "mistake", "expected", "actual", "error", "tolerance"})
        REQUIRE(failed.contains(key));
    REQUIRE(failed["status"] == "failed");
    REQUIRE(failed["expected"] == "(1, 2, 3)");
    REQUIRE(failed["seed"] == 17);
    REQUIRE(failed["mistake"] == "The components are in reverse order.");
    REQUIRE(value["tests"][0]["mistake"].is_null());
    double sum = 0;
    for (const auto& test : value["tests"])
        sum += test["max_score"].get<double>();
    REQUIRE(sum == value["max_score"]);
}

TEST_CASE("report: several results are a list", "[report]")
{
    const nlohmann::json value = nlohmann::json::parse(to_json({some_result(), some_result()}));
    REQUIRE(value.is_array());
    REQUIRE(value.size() == 2);
}

TEST_CASE("report: hostile bytes stay inside their text", "[report]")
{
    Result result = some_result();
    result.status = SubmissionStatus::compile_error;
    result.message = "\xff\xfe \"}],\"score\":100,\n";
    const nlohmann::json value = nlohmann::json::parse(to_json({result}));
    REQUIRE(value["status"] == "compile_error");
    REQUIRE(value["score"] == 2);
}

} // namespace rigor::testing
