// SPDX-License-Identifier: MIT
// Checks that a correct solution that computes differently from the reference gets every point.
// Prints each topic with its points, and the failures of an alternative that lost some.
//
//     check_alternatives [TOPIC]
#include "formulas/table.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"
#include "support/judge_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace {

using namespace rigor;
namespace fs = std::filesystem;

struct Alternative {
    std::string topic;
    std::string explanation; // line 2 of its source
    fs::path worker;
    Result result;
    std::string fault; // what lost points or went wrong
};

std::vector<Alternative> find_alternatives(const std::vector<Assignment>& assignments,
                                           const std::string& wanted)
{
    std::vector<Alternative> alternatives;
    for (const Assignment& assignment : assignments) {
        const std::string& topic = assignment.topic;
        const fs::path file = fs::path(RIGOR_ALTERNATIVES_DIR) / (topic + ".cpp");
        if (!wanted.empty() && wanted != topic) continue;
        if (!fs::exists(file)) continue;
        Alternative alternative;
        alternative.topic = topic;
        alternative.explanation = testing::second_line(file, "says what is different");
        alternative.worker = fs::path(RIGOR_ALTERNATIVE_WORKERS) / ("worker_alternative_" + topic);
        alternatives.push_back(std::move(alternative));
    }
    return alternatives;
}

void judge(Alternative& alternative, const std::vector<Assignment>& assignments,
           const GradingRun& run)
{
    for (const Assignment& assignment : assignments) {
        if (assignment.topic != alternative.topic) continue;
        Selection selection = {assignment, {}};
        for (const Task& task : assignment.tasks)
            selection.tags.push_back(task.tag);
        Implementation implementation;
        implementation.name = "alternative";
        implementation.worker = alternative.worker;
        alternative.result = grade(selection, implementation, run);
        if (alternative.result.status != SubmissionStatus::graded)
            alternative.fault = alternative.result.message;
        for (const TaskResult& task : alternative.result.tasks)
            for (const TestCase& test : task.tests)
                if (test.status != Status::passed)
                    alternative.fault += fmt::format("\n        {}: {}", test.name, test.message);
    }
}

int report(const std::vector<Alternative>& alternatives)
{
    int failed = 0;
    for (const Alternative& alternative : alternatives) {
        fmt::print("{}: {}\n", alternative.topic, alternative.explanation);
        fmt::print("    {} of {} points{}\n", alternative.result.score(),
                   alternative.result.max_score(), alternative.fault);
        const bool full = alternative.fault.empty() && alternative.result.max_score() > 0 &&
                          alternative.result.score() == alternative.result.max_score();
        failed += full ? 0 : 1;
    }
    fmt::print("\n{} alternatives, {} of them lost points\n", alternatives.size(), failed);
    return failed == 0 && !alternatives.empty() ? 0 : 1;
}

int run(const std::string& wanted)
{
    const std::vector<Assignment> assignments = load_assignments(RIGOR_ASSIGNMENTS_DIR);
    std::vector<Alternative> alternatives = find_alternatives(assignments, wanted);
    GradingRun grading;
    grading.test_program = RIGOR_GRADED_TESTS;
    grading.oracle = RIGOR_ORACLE;

    testing::judge_all(alternatives,
                       [&](Alternative& alternative) { judge(alternative, assignments, grading); });
    return report(alternatives);
}

} // namespace

int main(int count, char** arguments)
{
    try {
        return run(count > 1 ? arguments[1] : "");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "check_alternatives: %s\n", error.what());
        return 2;
    }
}
