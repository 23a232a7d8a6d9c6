// SPDX-License-Identifier: MIT
// The time that each skip saves: the times with and without it, the counter that shows its effect,
// and the difference of the results.
#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace rigor;

namespace {

constexpr int rounds = 5;
constexpr double least_saving = 1.1; // smallest speed-up, in the scene that the skip is for

// The largest difference of two elements; NaN, which exceeds every bound, if the sizes differ.
double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
    if (a.size() != b.size()) return std::numeric_limits<double>::quiet_NaN();
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = std::abs(a[i] - b[i]);
        if (!(difference <= largest)) largest = difference; // a NaN stays
    }
    return largest;
}

void measure(Bench& bench, const SkipCase& skip)
{
    std::vector<double> with, without, ratios;
    SkipRun first, second;
    for (int round = 0; round < rounds; ++round) {
        first = skip.with();
        second = skip.without();
        with.push_back(first.seconds);
        without.push_back(second.seconds);
        ratios.push_back(second.seconds / first.seconds);
    }
    const double difference = largest_difference(first.result, second.result);
    bench.row({{"skip", skip.skip},
               {"scene", skip.scene},
               {"with [ms]", median(with) * 1e3},
               {"without [ms]", median(without) * 1e3},
               {"saves", median(ratios)},
               {"counter", skip.counter},
               {"counted with", first.counter},
               {"counted without", second.counter},
               {"apart", difference},
               {"bound", skip.bound}});
    const std::string what = skip.skip + ", " + skip.scene + ": ";
    bench.reach({what + "times as fast", median(ratios), least_saving, "higher"});
    bench.reach({what + "what the counter tells apart", std::abs(first.counter - second.counter), 1,
                 "higher"});
    bench.reach({what + "results apart", difference, skip.bound, "lower"});
}

} // namespace

int main(int argc, char** argv)
{
    Bench bench("skips");
    for (const auto& cases : {switchable_skips, built_in_skips, mesh_skips, process_skips})
        for (const SkipCase& skip : cases())
            measure(bench, skip);
    bench.note("Each pair runs in turns, " + std::to_string(rounds) +
               " times; times are medians, `saves` is the median of the pairs' ratios. Apart: the "
               "largest difference of");
    bench.note("a coordinate of a body at the end [m], or of what was counted.");
    return bench.finish(wants_json(argc, argv));
}
