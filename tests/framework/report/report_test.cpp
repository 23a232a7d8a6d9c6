// SPDX-License-Identifier: MIT
#include "errors/input_error.hpp"
#include "report/result_json.hpp"
#include "report/table.hpp"
#include "report/terminal.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <sstream>

namespace rigor::testing {

namespace {

Task task_of(const std::string& tag, const std::string& formula, double points)
{
    Task task;
    task.tag = tag;
    task.formula = formula;
    task.points = points;
    task.hint = "Think of the transpose, and of which frame each matrix takes its argument from "
                "before it is multiplied.";
    return task;
}

// One task passed, one failed, one a stub.
Result some_result()
{
    Result result;
    result.assignment.name = "a2-inertia";
    result.assignment.topic = "inertia";
    result.assignment.title = "Inertia tensors";
    result.submission = "student";
    TestCase good, bad, stub;
    good.name = bad.name = stub.name = "inertia: it turns with the body";
    bad.status = Status::failed;
    bad.expected = "(1, 2, 3)";
    bad.actual = "(3, 2, 1)";
    bad.error = "2";
    bad.tolerance = "1.8e-15";
    bad.tolerance_class = "R";
    bad.seed = 17;
    stub.status = Status::not_implemented;
    stub.message = "A2.3 world_inverse_inertia is not implemented yet (student/inertia.cpp)";
    result.tasks = {score_task(task_of("A2.1", "particle_mass_properties", 2), {good}),
                    score_task(task_of("A2.2", "world_inertia", 1), {good, bad}),
                    score_task(task_of("A2.3", "world_inverse_inertia", 1), {stub}),
                    score_task(task_of("A2.15", "steps", 4), {stub})};
    return result;
}

std::string table_of(const Result& result)
{
    Implementation student;
    student.name = "student";
    student.folder = std::string(RIGOR_SOURCE_DIR) + "/student";
    return points_table(result, student, false);
}

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

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

TEST_CASE("report: a file is written whole or not at all", "[report]")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "result.json";
    write_whole(file, "first");
    write_whole(file, "second");
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    REQUIRE(text.str() == "second");
    REQUIRE(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
    REQUIRE_THROWS_AS(write_whole(folder.path() / "no" / "file", "x"), InputError);
}

TEST_CASE("report: the table says what broke and where and what to do next", "[report]")
{
    const std::string table = table_of(some_result());
    CAPTURE(table);
    REQUIRE(has(table, "A2.1   particle_mass_properties           2/2   passed"));
    REQUIRE(has(table, "failed, 1 of 2 laws broken"));
    REQUIRE(has(table, "it turns with the body"));
    REQUIRE(has(table, "2, allowed 1.8e-15 (rounding)"));
    REQUIRE(has(table, "./rigor check A2.2 --seed 17"));
    REQUIRE(has(table, "student/inertia.cpp:"));
    REQUIRE(has(table, "assignments/a2-inertia/README.md, A2.2"));
    REQUIRE(has(table, "waits for A2.3"));
    REQUIRE(has(table, "Next: A2.3 world_inverse_inertia (2 tasks are not implemented yet)"));
    REQUIRE(has(table, "2 of 8 points"));
}

TEST_CASE("report: the table fits into 80 columns", "[report]")
{
    Result result = some_result();
    std::istringstream lines(table_of(result));
    for (std::string line; std::getline(lines, line);) {
        CAPTURE(line);
        REQUIRE(columns(line) <= 80);
    }
}

TEST_CASE("report: colour is only where it is wanted", "[report]")
{
    REQUIRE(colored("x", Color::red, false) == "x");
    REQUIRE(colored("x", Color::red, true) == "\033[31mx\033[0m");
    REQUIRE_FALSE(has(table_of(some_result()), "\033"));
}

TEST_CASE("report: width counts characters and not bytes", "[report]")
{
    REQUIRE(columns("ω = I⁻¹ L") == 9);
    REQUIRE(padded("ω", 3) == "ω  ");
    REQUIRE(wrapped("one two three", 7, 2) == "one two\n  three");
    REQUIRE(wrapped("unbreakable", 4, 0) == "unbreakable");
}

} // namespace rigor::testing
