// SPDX-License-Identifier: MIT
#include "grading/assignment.hpp"

#include "errors/input_error.hpp"
#include "formulas/table.hpp"
#include "scene/keys/scene_keys.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <map>
#include <sstream>

namespace rigor::testing {

namespace {

const std::string one_task =
    R"({"tag": "A0.1", "formula": "kinetic_energy", "points": 1, "visibility": "visible", "hint": "Two terms."})";

std::string assignment_with(const std::string& tasks)
{
    return R"({"assignment": "a0-pipeline", "title": "First steps", "topic": "pipeline",
 "submit": ["pipeline.cpp"],
 "tasks": [
)" + tasks +
           "]}";
}

// The loader's error message for a file; empty if it accepts the file.
std::string complaint(const std::string& text)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.write("a0-pipeline/assignment.json", text);
    try {
        load_assignment(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

void require_complaint(const std::string& text, int line, const std::string& words)
{
    const std::string said = complaint(text);
    CAPTURE(said, words);
    REQUIRE(said.find("assignment.json:" + std::to_string(line) + ": ") != std::string::npos);
    REQUIRE(said.find(words) != std::string::npos);
}

std::vector<Assignment> shipped()
{
    return load_assignments(std::filesystem::path(RIGOR_SOURCE_DIR) / "assignments");
}

std::string content(const std::filesystem::path& file)
{
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

// The heading of a task in a handout: "### A2.14 `combine` (3 points)".
std::string heading(const Task& task)
{
    const std::string name = task.formula.empty() ? task.title : "`" + task.formula + "`";
    std::ostringstream points;
    points << task.points << (task.points == 1 ? " point" : " points");
    return "### " + task.tag + " " + name + " (" + points.str() +
           (task.is_hidden ? ", hidden)" : ")");
}

} // namespace

TEST_CASE("assignment: a good file is read whole", "[assignment]")
{
    const TemporaryFolder folder;
    const Assignment assignment =
        load_assignment(folder.write("a0-pipeline/assignment.json", assignment_with(one_task)));
    REQUIRE(assignment.name == "a0-pipeline");
    REQUIRE(assignment.label() == "a0");
    REQUIRE(assignment.points() == 1);
    REQUIRE(assignment.task("A0.1")->formula == "kinetic_energy");
    REQUIRE_FALSE(assignment.task("A0.1")->is_hidden);
    REQUIRE(assignment.task("A0.2") == nullptr);
}

TEST_CASE("assignment: an error names line and expectation", "[assignment]")
{
    require_complaint("{\n \"assignment\":", 2, "");
    require_complaint(assignment_with(""), 3, "at least one task");
    require_complaint(R"({"assignment": "a0-pipeline", "tiltle": "x"})", 1,
                      "did you mean \"title\"?");
    require_complaint(R"({"assignment": "a1"})", 1, "expected \"title\", found none");
    const auto task = [](const std::string& from, const std::string& to) {
        std::string text = one_task;
        text.replace(text.find(from), from.size(), to);
        return assignment_with(text);
    };
    require_complaint(task("\"points\": 1", "\"points\": 0"), 4, "points > 0");
    require_complaint(task("\"points\": 1", "\"points\": \"two\""), 4, "\"two\"");
    require_complaint(task("visible\"", "seen\""), 4, "expected one of \"visible\", \"hidden\"");
    require_complaint(task("Two terms.", ""), 4, "a hint");
    require_complaint(task("\"formula\": \"kinetic_energy\", ", ""), 4,
                      "either \"formula\" or \"title\"");
    const auto parts = [&](const std::string& text) {
        return task("\"points\": 1", "\"points\": 3, \"parts\": [" + text + "]");
    };
    const std::string part = R"({"law": "pipeline: a law", "points": 1})";
    require_complaint(parts(part + ", " + part), 4, "a law that no other part names");
    require_complaint(parts(R"({"law": "pipeline: a law", "points": 3})"), 4,
                      "expected parts of less than 3 points in all, found 3");
    require_complaint(parts(R"({"law": "pipeline: a law"})"), 4, "\"law\" and \"points\"");
    require_complaint(parts(R"({"law": "pipeline: a law", "points": -1})"), 4, "points > 0");
    require_complaint(parts(R"({"lew": "pipeline: a law"})"), 4, "did you mean \"law\"?");
}

TEST_CASE("assignment: the table of formulas and the tasks agree", "[assignment]")
{
    const auto with_tag = [](const std::string& tag, const std::string& formula) {
        return assignment_with(R"({"tag": ")" + tag + R"(", "formula": ")" + formula +
                               R"(", "points": 1, "visibility": "visible", "hint": "x"})");
    };
    require_complaint(with_tag("A0.1", "kinetic_enrgy"), 4,
                      "expected kinetic_energy, the formula A0.1");
    require_complaint(with_tag("A0.2", "kinetic_energy"), 4,
                      "the tag of a formula of topic pipeline");
    require_complaint(with_tag("A2.14", "combine"), 4, "the tag of a formula of topic pipeline");
    require_complaint(assignment_with(one_task + ",\n" + one_task), 5,
                      "a tag that no other task has");
    const std::string about_scenes =
        R"({"tag": "A0.9", "title": "Scenes", "points": 1, "visibility": "hidden", "hint": "x"})";
    require_complaint(assignment_with(about_scenes), 3,
                      "expected a task for A0.1 kinetic_energy, found none");
}

TEST_CASE("assignment: a folder without assignments is an error", "[assignment]")
{
    const TemporaryFolder folder;
    REQUIRE_THROWS_AS(load_assignments(folder.path()), InputError);
    REQUIRE_THROWS_AS(load_assignments(folder.path() / "none"), InputError);
}

TEST_CASE("assignment: every formula of the table is a task once among those that ship",
          "[assignment]")
{
    std::map<std::string, int> tasks;
    for (const Assignment& assignment : shipped())
        for (const Task& task : assignment.tasks)
            ++tasks[task.tag];
    for (const Formula& row : formulas) {
        CAPTURE(row.tag);
        REQUIRE(tasks[std::string(row.tag)] == 1);
    }
}

TEST_CASE("assignment: what ships is explained and there", "[assignment]")
{
    for (const Assignment& assignment : shipped()) {
        CAPTURE(assignment.name);
        const std::string handout = content(assignment.folder / "README.md");
        for (const Task& task : assignment.tasks) {
            CAPTURE(task.tag, heading(task));
            REQUIRE(handout.find("\n" + heading(task)) != std::string::npos);
            for (const std::string& below : task.builds_on) {
                CAPTURE(below);
                REQUIRE(below != task.tag);
                bool known = false;
                for (const Assignment& other : shipped())
                    known = known || other.task(below);
                REQUIRE(known);
            }
        }
        for (const std::string& file : assignment.submit)
            REQUIRE(std::filesystem::exists(std::filesystem::path(RIGOR_SOURCE_DIR) / "student" /
                                            file));
        for (const std::string& scene : assignment.scenes)
            REQUIRE_NOTHROW(load_scene(assignment.folder / "scenes" / scene));
    }
}

} // namespace rigor::testing
