// SPDX-License-Identifier: MIT
// How many wrong solutions the graded tests catch. The wrong solutions are mutants, which a program
// makes of the reference by small changes (tests/mutants/). Each one runs with the tests of its own
// task; a change in a function that several formulas call runs with the tests of its topic.
//
//     bench_validator [--json] [STEM or TAG or FORMULA]...
//
// The table has a row for each formula. A mutant that no test catches is a survivor; it is
// explained if tests/mutants/equivalent.txt says why it is no mistake.
//
// Without names the promises of two more benchmarks follow: `tolerances`, which runs the right
// solutions with several seeds and measures the margins, and `diagnosis`.
#include "benchmarks/validator/mutant_lists.hpp"
#include "grading/process.hpp"
#include "support/bench/bench.hpp"
#include "support/bench/reasons.hpp"
#include "support/judge_all.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <map>
#include <sstream>

namespace {

using namespace rigor;
using namespace rigor::mutants;
namespace fs = std::filesystem;

const fs::path folder = RIGOR_MUTANTS_FOLDER, programs = RIGOR_PROGRAMS_FOLDER;

// Much more than any test case takes. A loop that does not end is caught.
constexpr double longest_test = 20; // [s]
// Much more than any test needs. A loop that fills the memory is caught.
constexpr std::uint64_t most_memory = std::uint64_t{2} << 30; // [bytes]

std::vector<std::string> stems()
{
    std::vector<std::string> result;
    std::istringstream list(RIGOR_MUTANT_STEMS);
    for (std::string stem; list >> stem;)
        result.push_back(stem);
    return result;
}

struct Run {
    bool is_passed = false;
    int cases = 0;      // how many test cases ended
    std::string failed; // the one that failed
};

// Runs the tests of a mutant until one fails. The number 0 is the unchanged source.
Run run_tests(const std::string& stem, int number, const std::string& tag)
{
    Command command;
    command.arguments = {folder / ("graded_" + stem), "--verdicts",
                         std::to_string(message_descriptor), "--abort", "[" + tag + "]"};
    command.environment = {fmt::format("RIGOR_MUTANT={} {}", stem, number)};
    command.silence = longest_test;
    command.memory = most_memory;
    Run result;
    std::string last;
    const auto on_message = [&](std::string_view line) {
        const nlohmann::json message = nlohmann::json::parse(line);
        if (message.contains("end")) return;
        if (message.contains("begin")) {
            last = message["begin"];
            return;
        }
        ++result.cases;
    };
    const Ended ended = rigor::run(
        command, [](std::string_view) {}, on_message);
    result.is_passed = ended.ok();
    if (!ended.ok()) result.failed = last;
    return result;
}

// All tests must pass and check something without a mutant. Otherwise every mutant would count as
// caught, or none.
void check_unchanged(const std::vector<Mutant>& mutants)
{
    std::map<std::string, std::string> topics; // the topic of each stem
    for (const Mutant& mutant : mutants)
        topics[mutant.stem] = mutant.topic();
    for (const auto& [stem, topic] : topics) {
        const Run run = run_tests(stem, 0, topic);
        if (!run.is_passed || run.cases == 0)
            throw std::runtime_error(
                fmt::format("{}: expected all tests to pass without a mutant, found {} after {}",
                            stem, run.failed.empty() ? "no test" : run.failed, run.cases));
    }
}

void judge(Mutant& mutant)
{
    const std::string tag(mutant.formula ? mutant.formula->tag : mutant.topic());
    const Run run = run_tests(mutant.stem, mutant.number, tag);
    if (!run.is_passed)
        mutant.caught_by = run.failed.empty() ? "before the first test" : run.failed;
    else if (run.cases == 0)
        throw std::runtime_error("no test of " + tag);
}

bool is_wanted(const Mutant& mutant, const std::vector<std::string>& wanted)
{
    return wanted.empty() ||
           std::any_of(wanted.begin(), wanted.end(), [&](const std::string& word) {
               return word == mutant.stem || word == mutant.function ||
                      (mutant.formula && word == mutant.formula->tag);
           });
}

struct Tally {
    int mutants = 0, caught = 0, equivalent = 0;

    int unexplained() const { return mutants - caught - equivalent; }
};

void add_row(Bench& bench, const std::string& name, const Tally& tally)
{
    const int wrong = tally.mutants - tally.equivalent;
    bench.row({{"formula", name},
               {"mutants", double(tally.mutants)},
               {"equivalent", double(tally.equivalent)},
               {"caught", double(tally.caught)},
               {"caught [%]", wrong ? 100.0 * tally.caught / wrong : 100.0},
               {"unexplained", double(tally.unexplained())}});
}

// Entries of the list that are no survivors any more.
void note_outdated(Bench& bench, const std::vector<Mutant>& mutants,
                   const std::map<std::string, std::string>& equivalent, bool is_all)
{
    std::map<std::string, const Mutant*> known;
    for (const Mutant& mutant : mutants)
        known[mutant.path()] = &mutant;
    int outdated = 0;
    for (const auto& [path, reason] : equivalent) {
        const auto found = known.find(path);
        if (found == known.end() ? !is_all : found->second->caught_by.empty()) continue;
        bench.note("listed as equivalent, but " +
                   (found == known.end() ? std::string("there is no such mutant")
                                         : "caught by \"" + found->second->caught_by + "\"") +
                   ": " + path);
        ++outdated;
    }
    bench.reach({"outdated entries among the equivalent mutants", double(outdated), 0});
}

std::vector<Mutant> wanted_mutants(const std::vector<std::string>& wanted,
                                   const std::map<std::string, std::string>& equivalent)
{
    std::vector<Mutant> mutants;
    for (const std::string& stem : stems())
        for (Mutant& mutant : mutants_of(folder, stem)) {
            mutant.is_equivalent = equivalent.contains(mutant.path());
            if (is_wanted(mutant, wanted)) mutants.push_back(mutant);
        }
    if (mutants.empty()) throw std::invalid_argument("no mutant has one of these names");
    return mutants;
}

void add_rows(Bench& bench, const std::vector<Mutant>& mutants)
{
    std::map<std::string, Tally> tallies;
    Tally total;
    for (const Mutant& mutant : mutants) {
        const std::string name = mutant.formula
                                     ? fmt::format("{} {}", mutant.formula->tag, mutant.function)
                                     : "parts of " + mutant.stem;
        const bool survives = mutant.caught_by.empty();
        for (Tally* tally : {&tallies[name], &total}) {
            ++tally->mutants;
            tally->caught += !survives;
            tally->equivalent += survives && mutant.is_equivalent;
        }
        if (survives && !mutant.is_equivalent) bench.note("survives: " + mutant.path());
    }
    for (const auto& [name, tally] : tallies)
        add_row(bench, name, tally);
    add_row(bench, "all", total);
    bench.reach({"survivors without an explanation", double(total.unexplained()), 0});
}

// Runs another benchmark of the tests, and adds its promises.
void add_promises(Bench& bench, const std::string& name)
{
    std::fprintf(stderr, "validator: running the benchmark %s\n", name.c_str());
    Command command;
    command.arguments = {programs / ("bench_" + name), "--json"};
    command.shares_stderr = true;
    std::string output;
    const Ended ended = rigor::run(command, [&](std::string_view line) { output += line; });
    if (!ended.ok()) throw std::runtime_error("the benchmark " + name + " failed");
    for (const auto& promise : nlohmann::json::parse(output)["reach"])
        bench.reach({promise["what"], promise["figure"], promise["limit"], promise["better"]});
}

int run(bool is_json, const std::vector<std::string>& wanted)
{
    // Mutants that are as correct as the source, by their paths.
    const auto equivalent = testing::reasons_in(RIGOR_EQUIVALENT_MUTANTS);
    std::vector<Mutant> mutants = wanted_mutants(wanted, equivalent);
    check_unchanged(mutants);
    testing::judge_all(mutants, judge);

    Bench bench("validator");
    add_rows(bench, mutants);
    note_outdated(bench, mutants, equivalent, wanted.empty());
    if (wanted.empty())
        for (const char* name : {"tolerances", "diagnosis"})
            add_promises(bench, name);
    return bench.finish(is_json);
}

} // namespace

int main(int count, char** arguments)
{
    try {
        std::vector<std::string> wanted(arguments + 1, arguments + count);
        std::erase(wanted, "--json");
        return run(wants_json(count, arguments), wanted);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_validator: %s\n", error.what());
        return 1;
    }
}
