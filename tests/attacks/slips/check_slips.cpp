// SPDX-License-Identifier: MIT
// Checks what slips cost: in each topic, each slip costs no more than its own task or file, and the
// student gets a message.
//
//     check_slips [SLIP [TOPIC]]
//     check_slips --sample COUNT    this number of them, the same ones in every run
#include "formulas/table.hpp"
#include "grading/build/implementation.hpp"
#include "grading/places.hpp"
#include "grading/run_tests.hpp"
#include "slips.hpp"
#include "solutions.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <random>
#include <thread>
#include <unistd.h>

namespace {

using namespace rigor;
using namespace rigor::slips;
namespace fs = std::filesystem;

struct Case {
    const Slip* slip;
    const Place* place;
    std::string fault; // what was wrong; empty if all was as expected
    double seconds = 0;
};

std::string tag_of(const std::string& formula)
{
    for (const Formula& row : formulas)
        if (row.name == formula) return std::string(row.tag);
    throw std::logic_error("no formula " + formula);
}

std::string with_slip(const Slip& slip, const Place& place)
{
    if (slip.file) return slip.file(solution(place.topic));
    return solution_beside(place, slip.definition(place));
}

const Assignment& assignment_with(const std::vector<Assignment>& assignments,
                                  const std::string& tag)
{
    const auto found = std::find_if(assignments.begin(), assignments.end(),
                                    [&](const auto& each) { return each.task(tag) != nullptr; });
    if (found == assignments.end()) throw std::logic_error("no task " + tag);
    return *found;
}

bool may_lose(const Case& slipped, const std::string& formula)
{
    switch (slipped.slip->cost) {
    case Cost::nothing:
        return false;
    case Cost::its_task:
        return formula == slipped.place->name;
    case Cost::its_file:
        return formula == slipped.place->name || formula == slipped.place->neighbour;
    }
    return false;
}

// What was wrong with one formula's verdict; empty if nothing.
std::string fault_of(const Case& slipped, const std::string& formula, const Result& result)
{
    const TaskResult& task = result.tasks.at(0);
    if (result.status == SubmissionStatus::internal_error) return "a fault: " + result.message;
    if (!may_lose(slipped, formula)) {
        if (task.status == Status::passed) return "";
        const TestCase* failure = task.first_failure();
        return fmt::format("{} lost its points, {}: {}", formula, to_string(task.status),
                           failure ? failure->name + ": " + failure->message : result.message);
    }
    if (task.status == Status::passed) return formula + " kept its points";
    const bool is_told =
        result.status == SubmissionStatus::compile_error
            ? !result.message.empty()
            : std::any_of(task.tests.begin(), task.tests.end(),
                          [](const TestCase& test) { return !test.message.empty(); });
    return is_told ? "" : formula + " lost its points without a word";
}

void judge(Case& slipped, const fs::path& folder, const std::vector<Assignment>& assignments,
           const GradingRun& run)
{
    const auto start = std::chrono::steady_clock::now();
    for (const Place& place : places_of_slips())
        std::ofstream(folder / (place.topic + ".cpp"), std::ios::binary)
            << (&place == slipped.place ? with_slip(*slipped.slip, place) : solution(place.topic));
    copy_headers(folder);
    const Implementation implementation = build_implementation(folder.string());
    for (const Place& place : places_of_slips())
        for (const std::string& formula : {place.neighbour, place.name}) {
            const bool is_asked =
                !formula.empty() && slipped.fault.empty() &&
                (&place == slipped.place || formula != place.name || place.neighbour.empty());
            if (!is_asked) continue;
            const std::string tag = tag_of(formula);
            const Selection selection{assignment_with(assignments, tag), {tag}};
            slipped.fault = fault_of(slipped, formula, grade(selection, implementation, run));
        }
    slipped.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<Case> chosen(const std::vector<std::string>& arguments)
{
    std::vector<Case> cases;
    const bool is_sample = !arguments.empty() && arguments[0] == "--sample";
    for (const Slip& slip : all_slips())
        for (const Place& place : places_of_slips())
            if (is_sample || ((arguments.empty() || arguments[0] == slip.name) &&
                              (arguments.size() < 2 || arguments[1] == place.topic)))
                cases.push_back({&slip, &place, ""});
    if (is_sample) {
        std::mt19937 random(1);
        std::shuffle(cases.begin(), cases.end(), random);
        cases.resize(std::min<std::size_t>(cases.size(), std::stoul(arguments.at(1))));
    }
    if (cases.empty())
        throw std::invalid_argument("expected a slip, and a topic: none is so called");
    return cases;
}

int check(const std::vector<std::string>& arguments)
{
    std::vector<Case> cases = chosen(arguments);
    const std::vector<Assignment> assignments = load_assignments(RIGOR_ASSIGNMENTS_DIR);
    GradingRun run;
    run.test_program = RIGOR_GRADED_TESTS;
    // The limit of each call follows the reference's time for it, in this run and under this load.
    run.oracle = places().program("worker_reference");
    std::atomic<std::size_t> next = 0, judged = 0;
    const auto work = [&] {
        const testing::TemporaryFolder folder; // one for all, so that the right files stay compiled
        for (std::size_t i; (i = next++) < cases.size();) {
            try {
                judge(cases[i], folder.path(), assignments, run);
            } catch (const std::exception& exception) {
                cases[i].fault = exception.what();
            }
            if (isatty(STDERR_FILENO))
                fmt::print(stderr, "\r{} of {} slips", ++judged, cases.size());
        }
    };
    std::thread other(work);
    work();
    other.join();

    if (isatty(STDERR_FILENO)) fmt::print(stderr, "\r");

    int faults = 0;
    for (const Case& slipped : cases) {
        if (slipped.fault.empty()) continue;
        ++faults;
        fmt::print("{} in {}: {}\n", slipped.slip->name, slipped.place->topic,
                   slipped.fault.substr(0, 200));
    }
    const auto slowest =
        std::max_element(cases.begin(), cases.end(),
                         [](const Case& a, const Case& b) { return a.seconds < b.seconds; });
    fmt::print("{} slips, {} of them cost too much, too little, or nobody was told; the slowest "
               "took {:.1f} s: {} in {}\n",
               cases.size(), faults, slowest->seconds, slowest->slip->name, slowest->place->topic);
    return faults == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return check({argv + 1, argv + argc});
    } catch (const std::exception& exception) {
        fmt::print(stderr, "check_slips: {}\n", exception.what());
        return 2;
    }
}
