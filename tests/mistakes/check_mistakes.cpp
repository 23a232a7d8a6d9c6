// SPDX-License-Identifier: MIT
// Checks that every mistake is caught by a test of its own task, and prints each formula with its
// mistakes and the tests that caught them.
//
//     check_mistakes [TAG or FORMULA]
//     check_mistakes --matrix FOLDER [TAG or FORMULA]    also writes which law catches which one
//     check_mistakes --sample SEED TOPIC/FORMULA/MISTAKE...    some of them; SEED is only printed
#include "formulas/table.hpp"
#include "grading/run_tests.hpp"
#include "mistakes/kill_matrix.hpp"
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
    std::string explanation; // the second line of its file
    fs::path worker;
    std::string caught_by;                // the name of the test case; empty if none caught it
    std::string fault;                    // why it could not be judged; empty if it was
    std::vector<std::string> laws, kills; // the test cases that ran, and those that caught it
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

struct Wanted {
    std::string formula;             // tag or name; empty for all
    std::string seed;                // the seed that drew the sample
    std::vector<std::string> sample; // TOPIC/FORMULA/MISTAKE; empty for all
    std::string matrix;              // the folder of the kill matrix; empty for none

    bool is_all() const { return formula.empty() && sample.empty(); }
};

Wanted wanted_of(const std::vector<std::string>& arguments)
{
    if (arguments.empty()) return {};
    if (arguments[0] == "--matrix" && arguments.size() >= 2 && arguments.size() <= 3)
        return {arguments.size() == 3 ? arguments[2] : "", "", {}, arguments[1]};
    if (arguments[0] != "--sample" && arguments.size() == 1) return {arguments[0], "", {}, ""};
    if (arguments[0] != "--sample" || arguments.size() < 3)
        throw std::invalid_argument("expected a tag or formula, --matrix FOLDER, or --sample SEED "
                                    "MISTAKE...");
    return {"", arguments[1], {arguments.begin() + 2, arguments.end()}, ""};
}

std::vector<Mistake> find_mistakes()
{
    std::vector<Mistake> mistakes;
    for (const auto& entry : fs::recursive_directory_iterator(RIGOR_MISTAKES_DIR)) {
        const fs::path& file = entry.path();
        if (file.extension() != ".cpp" || file.parent_path() == RIGOR_MISTAKES_DIR) continue;
        const Formula& formula = formula_of(file);
        const std::string name = file.stem();
        const fs::path worker =
            fs::path(RIGOR_MISTAKE_WORKERS) /
            fmt::format("worker_mistake_{}.{}.{}", formula.topic, formula.name, name);
        Mistake mistake;
        mistake.formula = &formula;
        mistake.name = name;
        mistake.explanation = testing::second_line(file, "explains the mistake");
        mistake.worker = worker;
        mistakes.push_back(mistake);
    }
    std::sort(mistakes.begin(), mistakes.end(), [](const Mistake& a, const Mistake& b) {
        return std::pair(a.formula, a.name) < std::pair(b.formula, b.name);
    });
    return mistakes;
}

// The name of a mistake, TOPIC/FORMULA/MISTAKE.
std::string path_of(const Mistake& mistake)
{
    return fmt::format("{}/{}/{}", mistake.formula->topic, mistake.formula->name, mistake.name);
}

std::vector<Mistake> chosen(const std::vector<Mistake>& all, const Wanted& wanted)
{
    std::vector<Mistake> result;
    for (const Mistake& mistake : all) {
        const bool is_drawn = std::find(wanted.sample.begin(), wanted.sample.end(),
                                        path_of(mistake)) != wanted.sample.end(),
                   is_asked = wanted.formula == mistake.formula->tag ||
                              wanted.formula == mistake.formula->name;
        if (wanted.is_all() || is_drawn || is_asked) result.push_back(mistake);
    }
    if (!wanted.sample.empty() && result.size() != wanted.sample.size())
        throw std::invalid_argument(fmt::format("expected {} mistakes by name, found {} of them",
                                                wanted.sample.size(), result.size()));
    if (result.empty())
        throw std::invalid_argument(
            fmt::format("expected the tag or the name of a formula, found '{}'", wanted.formula));
    return result;
}

bool catches(Status status)
{
    return status == Status::failed || status == Status::not_finite ||
           status == Status::timed_out || status == Status::crashed;
}

void judge(Mistake& mistake, const std::vector<Assignment>& assignments, const GradingRun& run)
{
    // Without a worker every test fails, which would count as caught.
    if (!fs::exists(mistake.worker)) {
        mistake.fault = mistake.worker.string() + " is missing: it was not built";
        return;
    }
    const std::string tag(mistake.formula->tag);
    for (const Assignment& assignment : assignments) {
        if (!assignment.task(tag)) continue;
        Implementation implementation;
        implementation.name = mistake.name;
        implementation.worker = mistake.worker;
        const Result result = grade({assignment, {tag}}, implementation, run);
        if (result.status != SubmissionStatus::graded) mistake.fault = result.message;
        for (const TaskResult& task : result.tasks)
            for (const TestCase& test : task.tests) {
                mistake.laws.push_back(test.name);
                if (!catches(test.status)) continue;
                mistake.kills.push_back(test.name);
                if (mistake.caught_by.empty()) mistake.caught_by = test.name;
            }
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

void write_matrix(const std::string& folder, const std::vector<Mistake>& mistakes)
{
    std::vector<KillRow> rows;
    for (const Mistake& mistake : mistakes)
        rows.push_back(
            {mistake.formula, mistake.name, mistake.explanation, mistake.laws, mistake.kills});
    write_kill_matrix(folder, rows);
    fmt::print("the kill matrix is in {}/kill_matrix.html and kill_matrix.json\n", folder);
}

int run(const Wanted& wanted)
{
    const std::vector<Mistake> all = find_mistakes();
    std::vector<Mistake> mistakes = chosen(all, wanted);
    const std::vector<Assignment> assignments = load_assignments(RIGOR_ASSIGNMENTS_DIR);
    GradingRun grading;
    grading.test_program = RIGOR_GRADED_TESTS;

    testing::judge_all(mistakes, [&](Mistake& mistake) { judge(mistake, assignments, grading); });
    const int status = report(mistakes, wanted.is_all());
    if (!wanted.matrix.empty()) write_matrix(wanted.matrix, mistakes);
    if (!wanted.sample.empty())
        fmt::print("a sample: {} of {}, seed {}\n", mistakes.size(), all.size(), wanted.seed);
    return status;
}

} // namespace

int main(int count, char** arguments)
{
    try {
        return run(wanted_of({arguments + 1, arguments + count}));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "check_mistakes: %s\n", error.what());
        return 2;
    }
}
