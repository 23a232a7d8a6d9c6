// SPDX-License-Identifier: MIT
// Every mistake must be caught, by a test of its own task. Prints formula, mistake and the test that caught it.
//
//     check_mistakes [TAG or FORMULA]
#include "formulas/table.hpp"
#include "grading/run_tests.hpp"
#include "support/judge_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

namespace {

using namespace rigor;
namespace fs = std::filesystem;

struct Mistake {
    const Formula* formula = nullptr;
    std::string name;        // "transpose_forgotten"
    std::string explanation; // its second line
    fs::path worker;
    std::string caught_by; // the test case; empty: it slipped through
    std::string fault;     // ours
};

const Formula& formula_of(const fs::path& file)
{
    const fs::path folder = file.parent_path();
    const std::string topic = folder.parent_path().filename(), name = folder.filename();
    for (const Formula& formula : formulas)
        if (formula.topic == topic && formula.name == name) return formula;
    throw std::runtime_error(file.string() +
                             ": expected a mistake's name to be "
                             "<topic>/<formula>/<mistake>.cpp, found no formula '" +
                             topic + "::" + name + "'");
}

std::vector<Mistake> find_mistakes(const std::string& wanted)
{
    std::vector<Mistake> mistakes;
    for (const auto& entry : fs::recursive_directory_iterator(RIGOR_MISTAKES_DIR)) {
        const fs::path& file = entry.path();
        if (file.extension() != ".cpp" || file.parent_path() == RIGOR_MISTAKES_DIR) continue;
        const Formula& formula = formula_of(file);
        if (!wanted.empty() && wanted != formula.tag && wanted != formula.name) continue;
        const std::string name = file.stem();
        const fs::path worker =
            fs::path(RIGOR_MISTAKE_WORKERS) /
            fmt::format("worker_mistake_{}.{}.{}", formula.topic, formula.name, name);
        mistakes.push_back(
            {&formula, name, testing::second_line(file, "explains the mistake"), worker, "", ""});
    }
    std::sort(mistakes.begin(), mistakes.end(), [](const Mistake& a, const Mistake& b) {
        return std::pair(a.formula, a.name) < std::pair(b.formula, b.name);
    });
    return mistakes;
}

bool catches(Status status)
{
    return status == Status::failed || status == Status::not_finite ||
           status == Status::timed_out || status == Status::crashed;
}

void judge(Mistake& mistake, const std::vector<Assignment>& assignments, const GradingRun& run)
{
    const std::string tag(mistake.formula->tag);
    for (const Assignment& assignment : assignments) {
        if (!assignment.task(tag)) continue;
        Implementation implementation;
        implementation.name = mistake.name;
        implementation.worker = mistake.worker;
        const Result result = grade({assignment, {tag}}, implementation, run);
        if (result.status != SubmissionStatus::graded) mistake.fault = result.message;
        for (const TaskResult& task : result.tasks)
            for (const TestCase& test : task.tests)
                if (mistake.caught_by.empty() && catches(test.status))
                    mistake.caught_by = test.name;
    }
}

int report(const std::vector<Mistake>& mistakes, bool all)
{
    std::map<std::string_view, int> count;
    int passed = 0, failed = 0;
    const Formula* last = nullptr;
    for (const Mistake& mistake : mistakes) {
        if (mistake.formula != last)
            fmt::print("\n{} {}\n", mistake.formula->tag, mistake.formula->name);
        last = mistake.formula;
        ++count[mistake.formula->name];
        fmt::print("    {}: {}\n", mistake.name, mistake.explanation);
        if (!mistake.fault.empty())
            fmt::print("        FAULT: {}\n", mistake.fault);
        else if (mistake.caught_by.empty())
            fmt::print("        NOT CAUGHT\n");
        else
            fmt::print("        caught by \"{}\"\n", mistake.caught_by);
        ++(mistake.caught_by.empty() || !mistake.fault.empty() ? failed : passed);
    }
    for (const Formula& formula : formulas)
        if (all && count[formula.name] < 2) {
            fmt::print("\n{} {}: expected at least 2 mistakes, found {}\n", formula.tag,
                       formula.name, count[formula.name]);
            ++failed;
        }
    fmt::print("\n{} mistakes caught, {} failed\n", passed, failed);
    return failed == 0 && passed > 0 ? 0 : 1;
}

int run(const std::string& wanted)
{
    std::vector<Mistake> mistakes = find_mistakes(wanted);
    const std::vector<Assignment> assignments = load_assignments(RIGOR_ASSIGNMENTS_DIR);
    GradingRun grading;
    grading.test_program = RIGOR_GRADED_TESTS;

    testing::judge_all(mistakes, [&](Mistake& mistake) { judge(mistake, assignments, grading); });
    return report(mistakes, wanted.empty());
}

} // namespace

int main(int count, char** arguments)
{
    try {
        return run(count > 1 ? arguments[1] : "");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "check_mistakes: %s\n", error.what());
        return 2;
    }
}
