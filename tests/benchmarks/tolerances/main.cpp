// SPDX-License-Identifier: MIT
// How far right and wrong solutions are from the bounds of the graded tests. For each test the
// table has the largest error of a right solution (the reference and the alternatives, with several
// seeds) and the smallest error with which the test catches a known mistake, both as a part of the
// tolerance. The first should be at most a tenth. Each mistake should be caught by some test with
// ten tolerances or more. Exceptions are in reasons.txt, each with its reason. No right solution
// may fail a test.
//
//     bench_tolerances [--json] [--seeds N] [TOPIC]...
//
// Without a topic it takes all.
#include "benchmarks/tolerances/solutions.hpp"
#include "support/bench/bench.hpp"
#include "support/bench/reasons.hpp"
#include "support/judge_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <stdexcept>

namespace {

using namespace rigor;
using namespace rigor::tolerances;

constexpr double margin = 10;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Law {
    std::string tolerance_class;
    double right = 0, wrong = infinity; // errors, in tolerances
    std::string right_by, wrong_by;     // whose they are
    int mistakes = 0;                   // how many mistakes it catches
};

struct Judged {
    Solution solution;
    unsigned seed = 0;
    std::vector<Finding> findings;
    std::string fault;
};

using Laws = std::map<std::pair<std::string, std::string>, Law>; // by tag and name

std::vector<Judged> judged(unsigned seeds, const std::vector<std::string>& topics)
{
    const auto is_wanted = [&](const Solution& solution) {
        return topics.empty() ||
               std::find(topics.begin(), topics.end(), solution.topic) != topics.end();
    };
    std::vector<Judged> all;
    for (const Solution& solution : right_solutions())
        for (unsigned i = 0; i < seeds && is_wanted(solution); ++i)
            all.push_back({solution, 1000 * i, {}, ""}); // no property draws as many cases
    for (const Solution& solution : wrong_solutions())
        if (is_wanted(solution)) all.push_back({solution, 0, {}, ""});
    if (all.empty()) throw std::invalid_argument("there is no such topic");
    const std::vector<Assignment> assignments = load_assignments(RIGOR_ASSIGNMENTS_DIR);
    testing::judge_all(all, [&](Judged& one) {
        try {
            one.findings = findings(one.solution, assignments, one.seed);
        } catch (const std::exception& error) {
            one.fault = error.what();
        }
    });
    for (const Judged& one : all)
        if (!one.fault.empty()) throw std::runtime_error(one.fault);
    return all;
}

void add_right(const Judged& one, Laws& laws)
{
    for (const Finding& finding : one.findings) {
        Law& law = laws[{finding.tag, finding.law}];
        if (finding.error < law.right) continue;
        law.right = finding.error;
        law.right_by = one.solution.name;
    }
}

void add_wrong(const Judged& one, Laws& laws)
{
    for (const Finding& finding : one.findings) {
        if (finding.is_passed) continue;
        Law& law = laws[{finding.tag, finding.law}];
        ++law.mistakes;
        if (law.tolerance_class.empty()) law.tolerance_class = finding.tolerance_class;
        if (finding.error >= law.wrong) continue;
        law.wrong = finding.error;
        law.wrong_by = one.solution.name;
    }
}

/// The error of a mistake, in tolerances, in the test that catches it most clearly.
double clearest(const Judged& one)
{
    double largest = 0;
    for (const Finding& finding : one.findings)
        if (!finding.is_passed) largest = std::max(largest, finding.error);
    return largest;
}

class Report {
public:
    Report(Bench& bench, std::map<std::string, std::string> reasons, unsigned seeds)
        : bench_(bench), reasons_(std::move(reasons)), seeds_(seeds)
    {
    }

    void add(const Laws& laws)
    {
        for (const auto& [key, law] : laws) {
            bench_.row(
                {{"task", key.first},
                 {"test", key.second},
                 {"class", law.tolerance_class},
                 {"right, at most", law.right},
                 {"by", law.right_by},
                 {"mistakes", static_cast<double>(law.mistakes)},
                 {"wrong, at least", law.mistakes ? Bench::Value(law.wrong) : Bench::Value("")},
                 {"which", law.wrong_by}});
            if (law.right * margin > 1)
                near_ += is_unexplained(key.second, law.right, law.right_by);
        }
    }
    /// Counts the runs of right solutions, and names the tests that one of them failed.
    void add_right(const Judged& right)
    {
        ++right_;
        for (const Finding& finding : right.findings)
            if (!finding.is_passed) {
                ++refused_;
                bench_.note(fmt::format("refuses {} with seed {}: {}", right.solution.name,
                                        right.seed, finding.law));
            }
    }
    void add_wrong(const Judged& wrong)
    {
        const double error = clearest(wrong);
        if (error < margin)
            unclear_ += is_unexplained(wrong.solution.name, error, "the test that is clearest");
    }
    /// @param is_all  whether all topics were judged, so that each reason must have been needed
    int finish(bool is_json, bool is_all)
    {
        if (!is_all) reasons_.clear();
        for (const auto& [name, reason] : reasons_)
            bench_.note("has a reason that it does not need: " + name);
        bench_.reach({fmt::format("tests that refuse a right solution, in {} runs with {} seeds",
                                  right_, seeds_),
                      refused_, 0});
        bench_.reach({"tests of which a right solution uses over a tenth of the tolerance, "
                      "without a reason",
                      near_, 0});
        bench_.reach(
            {"mistakes that no test catches by ten tolerances, without a reason", unclear_, 0});
        bench_.reach({"reasons that are not needed", static_cast<double>(reasons_.size()), 0});
        return bench_.finish(is_json);
    }

private:
    int is_unexplained(const std::string& name, double error, const std::string& by)
    {
        if (reasons_.erase(name) > 0) return 0;
        bench_.note(fmt::format("{:.3g} tolerances by {}: {}", error, by, name));
        return 1;
    }

    Bench& bench_;
    std::map<std::string, std::string> reasons_;
    unsigned seeds_;
    int right_ = 0;
    double refused_ = 0, near_ = 0, unclear_ = 0;
};

int run(bool is_json, unsigned seeds, const std::vector<std::string>& topics)
{
    Bench bench("tolerances");
    Report report(bench, testing::reasons_in(RIGOR_REASONS), seeds);
    const std::vector<Judged> all = judged(seeds, topics);
    Laws laws;
    for (const Judged& one : all) {
        const bool is_right = one.solution.tag.empty();
        is_right ? add_right(one, laws) : add_wrong(one, laws);
        is_right ? report.add_right(one) : report.add_wrong(one);
    }
    report.add(laws);
    bench.note("errors are parts of the tolerance");
    return report.finish(is_json, topics.empty());
}

} // namespace

int main(int count, char** arguments)
{
    unsigned seeds = 3;
    std::vector<std::string> topics;
    for (int i = 1; i < count; ++i) {
        const std::string argument = arguments[i];
        if (argument == "--seeds" && i + 1 < count)
            seeds = static_cast<unsigned>(std::strtoul(arguments[++i], nullptr, 10));
        else if (argument != "--json")
            topics.push_back(argument);
    }
    try {
        return run(wants_json(count, arguments), seeds, topics);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_tolerances: %s\n", error.what());
        return 1;
    }
}
