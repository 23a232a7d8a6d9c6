// SPDX-License-Identifier: MIT
// Checks that a correct solution that computes differently from the reference gets every point.
// Prints each alternative with its points, and the failures of those that lost points. A solution
// for topic `contact` also runs with each solution of `collision`, whose formulas it calls.
//
//     check_alternatives [--seeds N] [--compiled] [--topic TOPIC]... [NAME]...
//
// Without a name or topic it checks all. N is the number of runs, each with another first seed.
// With --compiled it checks six builds of each, by g++ and clang++ at -O0, -O2 and -O3, which the
// target `compiled_alternatives` makes.
#include "formulas/table.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"
#include "support/judge_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace {

using namespace rigor;
namespace fs = std::filesystem;

struct Alternative {
    std::string name;        // "collision_inverse", "contact+collision_inverse"
    std::string explanation; // line 2 of its source
    fs::path worker;
    double points = 0, max_points = 0; // at the last seed
    std::string fault;                 // what lost points or went wrong, and at which seed

    std::string topic() const { return name.substr(0, name.find_first_of("_+.")); }
};

Alternative alternative(const std::string& name, const std::string& explanation)
{
    Alternative result;
    result.name = name;
    result.explanation = explanation;
    result.worker = fs::path(RIGOR_ALTERNATIVE_WORKERS) / ("worker_alternative_" + name);
    return result;
}

std::vector<Alternative> find_alternatives()
{
    std::vector<Alternative> alternatives;
    for (const auto& entry : fs::directory_iterator(RIGOR_ALTERNATIVES_DIR)) {
        const fs::path& file = entry.path();
        if (file.extension() != ".cpp" || file.stem() == "check_alternatives") continue;
        alternatives.push_back(
            alternative(file.stem(), testing::second_line(file, "says what is different")));
    }
    const std::size_t single = alternatives.size();
    for (std::size_t i = 0; i < single; ++i)
        for (std::size_t k = 0; k < single; ++k)
            if (alternatives[i].topic() == "contact" && alternatives[k].topic() == "collision")
                alternatives.push_back(alternative(
                    alternatives[i].name + "+" + alternatives[k].name, "both of them together."));
    std::sort(alternatives.begin(), alternatives.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
    return alternatives;
}

void judge(Alternative& alternative, const std::vector<Assignment>& assignments,
           const GradingRun& run)
{
    if (!fs::exists(alternative.worker)) {
        alternative.fault = alternative.worker.string() + " is missing: it was not built";
        return;
    }
    for (const Assignment& assignment : assignments) {
        if (assignment.topic != alternative.topic()) continue;
        Selection selection = {assignment, {}};
        for (const Task& task : assignment.tasks)
            selection.tags.push_back(task.tag);
        Implementation implementation;
        implementation.name = "alternative";
        implementation.worker = alternative.worker;
        const Result result = grade(selection, implementation, run);
        alternative.points = result.score();
        alternative.max_points = result.max_score();
        if (result.status != SubmissionStatus::graded) alternative.fault += result.message;
        for (const TaskResult& task : result.tasks)
            for (const TestCase& test : task.tests)
                if (test.status != Status::passed)
                    alternative.fault +=
                        fmt::format("\n        seed {}, {}: {}", run.seed, test.name, test.message);
    }
}

int report(const std::vector<Alternative>& alternatives)
{
    int failed = 0;
    for (const Alternative& alternative : alternatives) {
        fmt::print("{}: {}\n", alternative.name, alternative.explanation);
        fmt::print("    {} of {} points{}\n", alternative.points, alternative.max_points,
                   alternative.fault);
        const bool full = alternative.fault.empty() && alternative.max_points > 0 &&
                          alternative.points == alternative.max_points;
        failed += full ? 0 : 1;
    }
    fmt::print("\n{} alternatives, {} of them lost points\n", alternatives.size(), failed);
    return failed == 0 && !alternatives.empty() ? 0 : 1;
}

struct Wanted {
    std::vector<std::string> names, topics; // both empty for all
    unsigned seeds = 1;
    bool is_compiled = false;
};

Wanted wanted_of(const std::vector<std::string>& arguments)
{
    Wanted wanted;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == "--compiled")
            wanted.is_compiled = true;
        else if (arguments[i] == "--seeds" && i + 1 < arguments.size())
            wanted.seeds = static_cast<unsigned>(std::stoul(arguments[++i]));
        else if (arguments[i] == "--topic" && i + 1 < arguments.size())
            wanted.topics.push_back(arguments[++i]);
        else
            wanted.names.push_back(arguments[i]);
    }
    return wanted;
}

// The alternatives with one of the names or topics; all of them if none is given.
std::vector<Alternative> select(const std::vector<Alternative>& all, const Wanted& wanted)
{
    if (wanted.names.empty() && wanted.topics.empty()) return all;
    std::vector<Alternative> selected;
    const auto add_all = [&](const std::string& word, auto&& word_of) {
        const std::size_t before = selected.size();
        for (const Alternative& each : all)
            if (word_of(each) == word) selected.push_back(each);
        if (selected.size() == before)
            throw std::invalid_argument(fmt::format("no alternative or topic {}", word));
    };
    for (const std::string& name : wanted.names)
        add_all(name, [](const Alternative& each) { return each.name; });
    for (const std::string& topic : wanted.topics)
        add_all(topic, [](const Alternative& each) { return each.topic(); });
    return selected;
}

// Each alternative in the builds of both compilers at each level of optimization.
std::vector<Alternative> as_compiled(const std::vector<Alternative>& alternatives)
{
    std::vector<Alternative> result;
    for (const Alternative& each : alternatives)
        if (each.name.find('+') == std::string::npos) // pairs have no workers of their own here
            for (const char* way :
                 {"gxx-o0", "gxx-o2", "gxx-o3", "clangxx-o0", "clangxx-o2", "clangxx-o3"})
                result.push_back(alternative(each.name + "." + way, each.explanation));
    return result;
}

int run(const Wanted& wanted)
{
    const std::vector<Assignment> assignments = load_assignments(RIGOR_ASSIGNMENTS_DIR);
    std::vector<Alternative> alternatives = select(find_alternatives(), wanted);
    if (wanted.is_compiled) alternatives = as_compiled(alternatives);
    testing::judge_all(alternatives, [&](Alternative& each) {
        for (unsigned i = 0; i < wanted.seeds; ++i) {
            GradingRun grading;
            grading.test_program = RIGOR_GRADED_TESTS;
            grading.oracle = RIGOR_ORACLE;
            grading.seed = 1000 * i; // no property draws 1000 cases
            judge(each, assignments, grading);
        }
    });
    return report(alternatives);
}

} // namespace

int main(int count, char** arguments)
{
    try {
        return run(wanted_of({arguments + 1, arguments + count}));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "check_alternatives: %s\n", error.what());
        return 2;
    }
}
