// SPDX-License-Identifier: MIT
#include "errors/input_error.hpp"
#include "grading/assignment.hpp"
#include "grading/selection.hpp"
#include "support/catch.hpp"

namespace rigor::testing::selection_test {

namespace {

Task formula_task(const std::string& tag, const std::string& formula)
{
    Task task;
    task.tag = tag;
    task.formula = formula;
    task.points = 1;
    return task;
}

std::vector<Assignment> two_assignments()
{
    Assignment inertia, rotation;
    inertia.name = "a2-inertia";
    inertia.topic = "inertia";
    inertia.tasks = {formula_task("A2.1", "particle_mass_properties"),
                     formula_task("A2.14", "combine")};
    rotation.name = "a3-rotation";
    rotation.topic = "rotation";
    rotation.tasks = {formula_task("A3.1", "advance_matrix")};
    return {inertia, rotation};
}

using Tags = std::vector<std::string>;

Tags selected(const std::vector<std::string>& words)
{
    Tags result;
    for (const Selection& selection : select_tasks(two_assignments(), words))
        result.insert(result.end(), selection.tags.begin(), selection.tags.end());
    return result;
}

std::string complaint(const std::string& word)
{
    try {
        selected({word});
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("selection: no word is everything", "[selection]")
{
    REQUIRE(selected({}) == Tags{"A2.1", "A2.14", "A3.1"});
}

TEST_CASE("selection: assignment and topic and tag and formula all name tasks", "[selection]")
{
    const Tags inertia = {"A2.1", "A2.14"};
    for (const char* word : {"a2-inertia", "A2", "a2", "inertia", "Inertia"})
        REQUIRE(selected({word}) == inertia);
    REQUIRE(selected({"A2.14"}) == Tags{"A2.14"});
    REQUIRE(selected({"a2.14"}) == Tags{"A2.14"});
    REQUIRE(selected({"combine"}) == Tags{"A2.14"});
}

TEST_CASE("selection: tasks come once and in order", "[selection]")
{
    REQUIRE(selected({"combine", "rotation", "inertia", "A2.14"}) == Tags{"A2.1", "A2.14", "A3.1"});
}

TEST_CASE("selection: an unknown word gets the nearest name", "[selection]")
{
    REQUIRE(complaint("iertia").find("did you mean \"inertia\"?") != std::string::npos);
    REQUIRE(complaint("combin").find("did you mean \"combine\"?") != std::string::npos);
    REQUIRE(complaint("2").find("did you mean \"a2\"?") != std::string::npos);
    REQUIRE(complaint("A2.99").ends_with("found \"A2.99\"; its tasks are A2.1 to A2.14"));
    REQUIRE(complaint("a99.1").ends_with("found \"a99.1\"; `rigor list` names them"));
    REQUIRE(complaint("").find("expected an assignment") != std::string::npos);
    REQUIRE(complaint("zzzzzzzzzzzzz").find("did you mean") == std::string::npos);
}

} // namespace rigor::testing::selection_test
