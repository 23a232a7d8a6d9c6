// SPDX-License-Identifier: MIT
#include "ordinary_way.hpp"

#include "grading/build/submission_build.hpp"
#include "grading/places.hpp"
#include "grading/process.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"
#include "support/temporary_folder.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>

namespace rigor {

namespace {

namespace fs = std::filesystem;

Selection tasks_of(const std::string& words)
{
    return select_tasks(load_assignments(places().assignments()), {words}).at(0);
}

void must_run(const std::vector<std::string>& arguments, const fs::path& folder = {})
{
    Command command;
    command.arguments = arguments;
    command.folder = folder;
    std::string last;
    const Ended ended = run(command, [&](std::string_view line) { last = line; });
    if (!ended.ok())
        throw std::runtime_error(
            fmt::format("{}: expected status 0, found {}: {}", arguments[0], ended.status, last));
}

// A project of one program: the tests of A2's formulas, and the file of a student. The tests of
// scenes are left out, which would need the engine too.
void write_project(const fs::path& folder)
{
    const fs::path& tree = places().source;
    std::ofstream(folder / "CMakeLists.txt")
        << fmt::format(R"cmake(cmake_minimum_required(VERSION 3.18)
project(ordinary CXX)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_BUILD_TYPE Release)
find_package(Eigen3 REQUIRED)
find_package(Catch2 REQUIRED)
find_package(fmt REQUIRED)
file(GLOB tests {0}/tests/graded/inertia/*_test.cpp)
list(FILTER tests EXCLUDE REGEX _scenes_test)
set(support close framework_run free_rotor in_words main random seeds values/components verdict)
list(TRANSFORM support REPLACE "(.+)" "{0}/tests/support/\\1.cpp")
add_executable(all_tests ${{tests}} ${{support}} {0}/framework/seeds/drawn_seed.cpp {1}/inertia.cpp)
target_include_directories(all_tests PRIVATE {0}/framework {0}/tests)
target_link_libraries(all_tests PRIVATE Eigen3::Eigen Catch2::Catch2 fmt::fmt nettle)
)cmake",
                       tree.string(), folder.string());
}

void copy_solution(const fs::path& folder)
{
    fs::copy_file(places().source / "reference/inertia.cpp", folder / "inertia.cpp");
}

} // namespace

void measure_ordinary_way(Bench& bench)
{
    const testing::TemporaryFolder one_program, submission;
    copy_solution(one_program.path());
    copy_solution(submission.path());
    write_project(one_program.path());
    const std::string folder = one_program.path().string(), build = folder + "/build";
    const double ordinary = seconds([&] {
        must_run({"cmake", "-G", "Ninja", "-S", folder, "-B", build});
        must_run({"ninja", "-C", build});
        must_run({build + "/all_tests"});
    });
    const double here = seconds([&] {
        const Implementation implementation = build_implementation(submission.path().string());
        const Result result = grade(tasks_of("a2"), implementation, own_grading_run());
        if (!result.all_points()) throw std::runtime_error("A2 lost points: " + result.message);
    });
    remove_submission_build(submission.path());
    bench.row({{"A2 from the file to the verdicts", "here"}, {"time [s]", here}});
    bench.row({{"A2 from the file to the verdicts", "one program, without scenes"},
               {"time [s]", ordinary}});
    bench.reach({"times that A2 is faster than one program", ordinary / here, 8, "higher"});
}

void measure_against_before(Bench& bench)
{
    const char* before = std::getenv("RIGOR_BEFORE");
    if (!before) {
        bench.note("RIGOR_BEFORE names no other tree, so check is not compared with one");
        return;
    }
    const auto check = [](const fs::path& tree, const std::string& label) {
        return [command = std::vector<std::string>{(tree / "rigor").string(), "check", label,
                                                   "--with", "reference"},
                tree] { must_run(command, tree); };
    };
    for (const Assignment& assignment : load_assignments(places().assignments())) {
        const std::string label = assignment.label();
        const auto [now, then] =
            paired_seconds(check(places().source, label), check(before, label), 5);
        bench.row({{"check of", assignment.name},
                   {"time [s]", now},
                   {"of the other tree [s]", then},
                   {"ratio", now / then}});
        bench.reach(
            {"check of " + assignment.name + " over that of the other tree", now / then, 1.5});
    }
}

} // namespace rigor
