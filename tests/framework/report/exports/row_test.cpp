// SPDX-License-Identifier: MIT
#include "report/exports/row.hpp"

#include "framework/report/results.hpp"
#include "report/result_json.hpp"
#include "support/catch.hpp"

#include <nlohmann/json.hpp>

namespace rigor::testing {

TEST_CASE("row: it is what result.json says", "[report]")
{
    Result result = some_result();
    result.fingerprint = "0123456789abcdef";
    const std::optional<Row> row = read_row(to_json({result}));
    REQUIRE(row);
    CHECK(row->submission == "student");
    CHECK(row->assignment == "a2-inertia");
    CHECK(row->status == "graded");
    CHECK(row->fingerprint == "0123456789abcdef");
    CHECK(row->points == result.score());
    CHECK(row->max_points == result.max_score());
    REQUIRE(row->tasks.size() == 4);
    CHECK(row->tasks[1].tag == "A2.2");
    CHECK(row->tasks[1].status == "failed");
    CHECK(row->tasks[0].points == 2);
}

TEST_CASE("row: what is no whole result is none", "[report]")
{
    const std::string text = to_json({some_result()});
    for (const std::size_t size : {std::size_t{0}, std::size_t{10}, text.size() / 2})
        CHECK(!read_row(text.substr(0, size)));
    nlohmann::json json = nlohmann::json::parse(text);
    json["score"] = 8; // more than the tasks have together
    CHECK(!read_row(json.dump()));
    json = nlohmann::json::parse(text);
    json["tests"] = nlohmann::json::array();
    CHECK(!read_row(json.dump()));
    CHECK(!read_row("[]"));
    CHECK(!read_row("{\"submission\": 3}"));
}

} // namespace rigor::testing
