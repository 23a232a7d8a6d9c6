// SPDX-License-Identifier: MIT
// The cost of the walls (the sandbox) around a program: from the start of the launcher until the
// first answer of a small static program, in each tier that is possible here, and beside it the
// processor time of all processes that take part, also for ending them.
#include "sandbox/confined.hpp"
#include "support/bench/bench.hpp"

#include <optional>
#include <poll.h>
#include <stdexcept>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

using namespace rigor;

namespace {

constexpr int runs = 200;

double processor_seconds(int whose)
{
    rusage used = {};
    getrusage(whose, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

double processor_seconds()
{
    return processor_seconds(RUSAGE_SELF) + processor_seconds(RUSAGE_CHILDREN);
}

void await_answer(int output)
{
    pollfd waiting = {output, POLLIN, 0};
    char answer[6];
    if (poll(&waiting, 1, 10000) != 1 || read(output, answer, sizeof answer) != sizeof answer)
        throw std::runtime_error("the program did not answer");
}

struct Costs {
    std::vector<double> start, all, processor; // [s]
};

void run_once(Tier tier, Costs& costs)
{
    const double before = processor_seconds();
    const Ends output = output_pipe();
    const Descriptor nothing = no_input();
    costs.all.push_back(seconds([&] {
        std::optional<Confined> program;
        costs.start.push_back(seconds([&] {
            const int descriptors[] = {nothing, output.write, output.write};
            program.emplace(Confinement{Profile::worker, tier},
                            std::vector<std::string>{RIGOR_HELLO}, descriptors);
            await_answer(output.read);
        }));
    }));
    costs.processor.push_back(processor_seconds() - before);
}

} // namespace

int main(int argc, char** argv)
{
    Bench bench("walls");
    const auto limit_of = [](Tier tier) { return tier == Tier::a ? 12.0 : 6.0; };
    for (const Tier tier : {Tier::a, Tier::b, Tier::c}) {
        if (!is_possible(tier, possible_walls())) continue;
        Costs costs;
        for (int i = 0; i < runs; ++i)
            run_once(tier, costs);
        bench.row({{"tier", description(tier)},
                   {"first answer [ms]", 1e3 * median(costs.start)},
                   {"with its end [ms]", 1e3 * median(costs.all)},
                   {"processor time [ms]", 1e3 * median(costs.processor)},
                   {"times", static_cast<double>(runs)}});
        bench.reach({"first answer in tier " + description(tier).substr(0, 1) + ", median [ms]",
                     1e3 * median(costs.start), limit_of(tier)});
    }
    bench.note("a static program that prints a word; limits for two free processors");
    return bench.finish(wants_json(argc, argv));
}
