// SPDX-License-Identifier: MIT
#include "benchmarks/tolerances/solutions.hpp"

#include "diagnosis/workers/known_mistakes.hpp"
#include "grading/run_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <set>
#include <stdexcept>

namespace rigor::tolerances {

namespace fs = std::filesystem;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double error_of(const TestCase& test)
{
    if (test.status == Status::passed) return test.largest_error;
    const double error = std::strtod(test.error.c_str(), nullptr),
                 tolerance = std::strtod(test.tolerance.c_str(), nullptr);
    return test.status == Status::failed && tolerance > 0 ? error / tolerance : infinity;
}

} // namespace

std::vector<Solution> right_solutions()
{
    const fs::path build = RIGOR_BINARY_DIR;
    std::vector<Solution> result;
    std::set<std::string_view> topics;
    for (const Formula& formula : formulas)
        if (topics.insert(formula.topic).second)
            result.push_back(
                {"reference", build / "bin/worker_reference", std::string(formula.topic), ""});
    const std::string before = "worker_alternative_";
    for (const auto& entry : fs::directory_iterator(build / "alternatives")) {
        const std::string file = entry.path().filename();
        // A name with a dot is an alternative as one of several compilers made it.
        if (!file.starts_with(before) || file.find('.') != std::string::npos) continue;
        const std::string name = file.substr(before.size());
        result.push_back({name, entry.path(), name.substr(0, name.find_first_of("_+")), ""});
    }
    std::sort(result.begin(), result.end(), [](const Solution& a, const Solution& b) {
        return std::pair(a.topic, a.name) < std::pair(b.topic, b.name);
    });
    return result;
}

std::vector<Solution> wrong_solutions()
{
    std::vector<Solution> result;
    for (unsigned i = 0; i < formula_count; ++i)
        for (const diagnosis::KnownMistake& mistake :
             known_mistakes(diagnosis::own_mistake_folders(), FormulaIndex{i})) {
            const Formula& formula = formulas[i];
            result.push_back({fmt::format("{}/{}/{}", formula.topic, formula.name, mistake.name),
                              mistake.worker, std::string(formula.topic),
                              std::string(formula.tag)});
        }
    return result;
}

std::vector<Finding> findings(const Solution& solution, const std::vector<Assignment>& assignments,
                              unsigned seed)
{
    GradingRun run;
    run.test_program = RIGOR_GRADED_TESTS;
    run.seed = seed;
    // Hidden tests, which only a right solution runs here, need the oracle.
    if (solution.tag.empty()) run.oracle = fs::path(RIGOR_BINARY_DIR) / "bin/worker_reference";
    Implementation implementation;
    implementation.name = solution.name;
    implementation.worker = solution.worker;
    std::vector<Finding> result;
    for (const Assignment& assignment : assignments) {
        if (assignment.topic != solution.topic) continue;
        Selection selection = {assignment, {}};
        for (const Task& task : assignment.tasks)
            if (solution.tag.empty() || task.tag == solution.tag)
                selection.tags.push_back(task.tag);
        const Result graded = grade(selection, implementation, run);
        if (graded.status != SubmissionStatus::graded)
            throw std::runtime_error(solution.name + ": " + graded.message);
        for (const TaskResult& task : graded.tasks)
            for (const TestCase& test : task.tests)
                result.push_back({task.task.tag, test.name, test.tolerance_class,
                                  test.status == Status::passed, error_of(test)});
    }
    if (result.empty()) throw std::runtime_error(solution.name + ": no test ran");
    return result;
}

} // namespace rigor::tolerances
