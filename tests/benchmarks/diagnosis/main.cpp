// SPDX-License-Identifier: MIT
// How many mistakes are named, and how many wrongly. Each known mistake is diagnosed with all known
// mistakes, with all but itself, and by relations alone. The relations were tuned on one half of
// the mistakes, drawn by a seed; the other half shows how they do on mistakes that are new to them.
// A relation that none of three other draws of inputs confirms counts as false. Correct solutions
// are diagnosed as well, and nothing may be said of them.
#include "diagnosis/workers/diagnosis.hpp"
#include "support/bench/bench.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>

namespace {

using namespace rigor;
using diagnosis::Diagnosis;
using diagnosis::KnownMistake;
using By = Diagnosis::By;
namespace fs = std::filesystem;

constexpr unsigned split_seed = 1;

struct Counts {
    double mistakes = 0, known = 0, by_others = 0, related = 0, in_part = 0, false_ones = 0;
    double longest = 0; // [s]
};

class Measurement {
public:
    explicit Measurement(bool lists)
        : reference_(fs::path(RIGOR_BINARY_DIR) / "bin/worker_reference"), lists_(lists)
    {
    }

    void judge(FormulaIndex formula, const KnownMistake& mistake, Counts& counts);
    /// Diagnoses a correct solution for all formulas. @return how many were said to be wrong
    int accusations(const fs::path& worker);

private:
    Diagnosis asked(FormulaIndex formula, const fs::path& worker, diagnosis::Means means);

    Worker reference_;
    bool lists_;
};

Diagnosis Measurement::asked(FormulaIndex formula, const fs::path& worker, diagnosis::Means means)
{
    means.implementation = worker;
    means.reference = &reference_;
    means.time *= 3; // a busy machine must not change the figures
    return diagnose(formula, {}, means);
}

// A sentence without its numbers, which may depend on the inputs that were drawn.
std::string without_numbers(std::string sentence)
{
    std::erase_if(sentence, [](unsigned char c) {
        return std::isdigit(c) != 0 || c == '.' || c == 'e' || c == '-' || c == '+';
    });
    return sentence;
}

void Measurement::judge(FormulaIndex formula, const KnownMistake& mistake, Counts& counts)
{
    diagnosis::Means all, others, relations, again;
    others.left_out = mistake.name;
    others.uses_relations = false;
    relations.uses_known = again.uses_known = false;
    Diagnosis known;
    counts.longest =
        std::max(counts.longest, seconds([&] { known = asked(formula, mistake.worker, all); }));
    const Diagnosis other = asked(formula, mistake.worker, others),
                    related = asked(formula, mistake.worker, relations);
    bool is_confirmed = related.sentence.empty();
    for (again.seed = 1; !is_confirmed && again.seed <= 3; ++again.seed)
        is_confirmed = without_numbers(asked(formula, mistake.worker, again).sentence) ==
                       without_numbers(related.sentence);
    ++counts.mistakes;
    counts.known += !known.sentence.empty();
    counts.by_others += !other.sentence.empty();
    counts.in_part += related.by == By::part;
    counts.related += !related.sentence.empty() && related.by != By::part && is_confirmed;
    counts.false_ones += !is_confirmed;
    if (!lists_) return;
    std::printf("%s/%s: %s\n", std::string(formulas[static_cast<unsigned>(formula)].name).c_str(),
                mistake.name.c_str(), mistake.explanation.c_str());
    if (known.mistake != mistake.name)
        std::printf("    NAMED: %s %s\n", known.mistake.c_str(), known.sentence.c_str());
    if (!other.mistake.empty()) std::printf("    like %s\n", other.mistake.c_str());
    std::printf("    %s%s\n", related.by == By::part ? "PART: " : "", related.sentence.c_str());
    if (!is_confirmed) std::printf("    NOT CONFIRMED\n");
}

int Measurement::accusations(const fs::path& worker)
{
    int accused = 0;
    for (unsigned f = 0; f < formula_count; ++f) {
        const Diagnosis said = asked(FormulaIndex{f}, worker, {});
        if (said.sentence.empty()) continue;
        ++accused;
        std::printf("%s, %s: %s\n", worker.filename().c_str(),
                    std::string(formulas[f].name).c_str(), said.sentence.c_str());
    }
    return accused;
}

std::vector<fs::path> correct_solutions()
{
    const fs::path build = RIGOR_BINARY_DIR;
    std::vector<fs::path> result = {build / "bin/worker_reference"};
    for (const auto& entry : fs::directory_iterator(build / "alternatives"))
        if (entry.path().filename().string().starts_with("worker_")) result.push_back(entry.path());
    std::sort(result.begin(), result.end());
    return result;
}

void add_row(Bench& bench, const std::string& which, const Counts& counts)
{
    const auto percent = [&](double n) { return 100 * n / std::max(counts.mistakes, 1.0); };
    bench.row({{"mistakes", which},
               {"n", counts.mistakes},
               {"named [%]", percent(counts.known)},
               {"like another [%]", percent(counts.by_others)},
               {"by a relation [%]", percent(counts.related)},
               {"part only [%]", percent(counts.in_part)},
               {"false [%]", percent(counts.false_ones)},
               {"longest [s]", counts.longest}});
}

int run(bool json, bool lists)
{
    Bench bench("diagnosis");
    Measurement measurement(lists);
    testing::Random random(split_seed);
    Counts tuned, new_ones, all;
    for (unsigned f = 0; f < formula_count; ++f)
        for (const KnownMistake& mistake :
             known_mistakes(diagnosis::own_mistake_folders(), FormulaIndex{f})) {
            Counts& half = random.bits() % 2 == 0 ? tuned : new_ones;
            Counts one;
            measurement.judge(FormulaIndex{f}, mistake, one);
            for (Counts* counts : {&half, &all}) {
                counts->mistakes += one.mistakes;
                counts->known += one.known;
                counts->by_others += one.by_others;
                counts->related += one.related;
                counts->in_part += one.in_part;
                counts->false_ones += one.false_ones;
                counts->longest = std::max(counts->longest, one.longest);
            }
        }
    int accused = 0;
    const std::vector<fs::path> correct = correct_solutions();
    for (const fs::path& worker : correct)
        accused += measurement.accusations(worker);
    add_row(bench, "tuned with", tuned);
    add_row(bench, "held out", new_ones);
    add_row(bench, "all", all);
    bench.reach({"mistakes named [%]", 100 * all.known / all.mistakes, 95, "higher"});
    bench.reach({"held-out mistakes described falsely [%]",
                 100 * new_ones.false_ones / new_ones.mistakes, 1});
    bench.reach(
        {"correct solutions with something said of them, of " + std::to_string(correct.size()),
         static_cast<double>(accused), 0});
    return bench.finish(json);
}

} // namespace

int main(int argc, char** argv)
{
    const bool lists = std::any_of(argv, argv + argc, [](const char* argument) {
        return std::strcmp(argument, "--list") == 0;
    });
    try {
        return run(wants_json(argc, argv), lists);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench diagnosis: %s\n", error.what());
        return 3;
    }
}
