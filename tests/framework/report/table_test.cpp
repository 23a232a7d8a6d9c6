// SPDX-License-Identifier: MIT
#include "report/table.hpp"
#include "report/terminal.hpp"
#include "results.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>

#include <sstream>
#include <sys/stat.h>
#include <vector>

namespace rigor::testing {

namespace {

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

TEST_CASE("report: the table says what broke and where and what to do next", "[report]")
{
    const std::string table = table_of(some_result());
    CAPTURE(table);
    REQUIRE(has(table, "A2.1   particle_mass_properties           2/2   passed"));
    REQUIRE(has(table, "failed, 1 of 2 laws broken"));
    REQUIRE(has(table, "it turns with the body"));
    REQUIRE(has(table, "2, allowed 1.8e-15 (rounding)"));
    REQUIRE(has(table, "the mistake   The components are in reverse order.\n"));
    REQUIRE(has(table, "./rigor check A2.2 --seed 17"));
    REQUIRE(has(table, "student/inertia.cpp:"));
    REQUIRE(has(table, "assignments/a2-inertia/README.md, A2.2"));
    REQUIRE(has(table, "calls A2.3, a stub"));
    REQUIRE(has(table, "Next: A2.3 world_inverse_inertia (2 tasks are not implemented yet)"));
    REQUIRE(has(table, "2 of 8 points"));
}

TEST_CASE("report: the next step is the stub that a task calls", "[report]")
{
    Result result = some_result();
    TestCase waits;
    waits.name = "collision: the deepest contact comes first";
    waits.status = Status::not_implemented;
    waits.message = "A4.8 sliding_friction_impulse is not implemented yet (student/collision.cpp)";
    for (const char* formula : {"collision_impulse", ""}) { // a formula, and a task on scenes
        result.tasks = {score_task(task_of("A4.9", formula, 3), {waits})};
        const std::string table = table_of(result);
        CAPTURE(table);
        REQUIRE(has(table, "calls A4.8, a stub"));
        REQUIRE(has(table, "Next: A4.8 sliding_friction_impulse\n"));
        REQUIRE(has(table, "student/collision.cpp:"));
        REQUIRE(has(table, "assignments/a4-collision/README.md, A4.8"));
    }
}

TEST_CASE("report: other broken laws are named whole, and counted where they are many", "[report]")
{
    Result result = some_result();
    std::vector<TestCase> broken(12);
    for (std::size_t i = 0; i < broken.size(); ++i) {
        broken[i].name = fmt::format("inertia: law {} has a name of about fifty characters", i);
        broken[i].status = Status::failed;
    }
    result.tasks[1] = score_task(task_of("A2.2", "world_inertia", 1), broken);
    std::istringstream words(table_of(result));
    std::string table;
    for (std::string word; words >> word;)
        table += word + " ";
    CAPTURE(table);
    CHECK(has(table, "law 1 has a name"));
    CHECK(has(table, "; and 2 more"));
    CHECK_FALSE(has(table, "…"));
}

TEST_CASE("report: the place of a formula is sought in plain files alone", "[report]")
{
    const TemporaryFolder folder;
    Implementation eve;
    eve.name = "eve";
    eve.folder = folder.path();
    const auto place = [&] { return place_of(eve, "kinematics", "point_velocity"); };
    const auto file = folder.write("kinematics.cpp", "\nVector3d point_velocity(double)\n{\n}\n");
    REQUIRE(place() == "eve/kinematics.cpp:2");
    resize_file(file, std::uintmax_t{1} << 36); // takes no space on the disk
    REQUIRE(place() == "eve/kinematics.cpp");
    remove(file);
    REQUIRE(place() == "eve/kinematics.cpp");
    std::filesystem::create_symlink("/dev/zero", file); // which never ends
    REQUIRE(place() == "eve/kinematics.cpp");
    remove(file);
    REQUIRE(mkfifo(file.c_str(), 0600) == 0); // which nobody writes to
    REQUIRE(place() == "eve/kinematics.cpp");
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

TEST_CASE("report: a table without color has no escape sequence", "[report]")
{
    REQUIRE_FALSE(has(table_of(some_result()), "\033"));
}

} // namespace rigor::testing
