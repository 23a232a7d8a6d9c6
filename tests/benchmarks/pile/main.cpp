// SPDX-License-Identifier: MIT
// The time of a step in a pile of cubes, and how deep the cubes penetrate each other, compared with
// Bullet and ODE if they are installed. Further parts measure a settled pile, two threads, and
// piles of nonconvex bodies.
#include "nonconvex.hpp"
#include "options.hpp"
#include "rigid/step/step.hpp"
#include "run.hpp"
#include "support/bench/bench.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <span>
#include <stdexcept>

using namespace rigor;

namespace {

struct Contestant {
    std::string engine, mode;
    std::function<PileRun(const PileStart&, const PileOptions&)> run;
    bool sleep = true;
};

// The result of one contestant's runs of one pile.
struct Outcome {
    // Mean time of all steps and of the last 100 steps [ms], one entry for each round.
    std::vector<double> means, lasts;
    PileMeasure measure;
    double asleep = 0;
};

// Our engine, and the other engines that were installed when this was built.
std::vector<Contestant> contestants()
{
    std::vector<Contestant> all = {{"rigor", "kept awake", pile_rigor, false},
                                   {"rigor", "may sleep", pile_rigor, true}};
#ifdef RIGOR_BULLET
    all.push_back({"bullet", "kept awake", pile_bullet, false});
    all.push_back({"bullet", "may sleep", pile_bullet, true});
#endif
#ifdef RIGOR_ODE
    all.push_back({"ode", "kept awake", pile_ode, false});
#endif
    return all;
}

double mean_ms(std::span<const double> seconds)
{
    return 1e3 * std::accumulate(seconds.begin(), seconds.end(), 0.0) /
           static_cast<double>(seconds.size());
}

// Measures all contestants in each round, so that a slow phase of the machine affects all of them.
std::vector<Outcome> measure(const std::vector<Contestant>& all, int side, const PileChoice& choice)
{
    const PileStart start = pile_start(side);
    std::vector<Outcome> outcomes(all.size());
    for (int round = 0; round < choice.rounds; ++round)
        for (std::size_t c = 0; c < all.size(); ++c) {
            const PileOptions options{choice.steps, 1, all[c].sleep};
            const PileRun run = in_fresh_process([&] { return all[c].run(start, options); });
            const std::span<const double> times(run.step_seconds);
            outcomes[c].means.push_back(mean_ms(times));
            outcomes[c].lasts.push_back(
                mean_ms(times.last(std::min<std::size_t>(times.size(), 100))));
            outcomes[c].measure = measure_pile(start, run.cubes);
            outcomes[c].asleep = run.asleep;
        }
    return outcomes;
}

void report(Bench& bench, const Contestant& contestant, int cubes, const Outcome& outcome)
{
    const PileMeasure& m = outcome.measure;
    bench.row({{"cubes", static_cast<double>(cubes)},
               {"engine", contestant.engine},
               {"mode", contestant.mode},
               {"time a step [ms]", median(outcome.means)},
               {"last 100 [ms]", median(outcome.lasts)},
               {"asleep", outcome.asleep},
               {"mean depth [mm]", m.mean * 1e3},
               {"largest [mm]", m.largest * 1e3},
               {"pairs", static_cast<double>(m.pairs)},
               {"escaped", static_cast<double>(m.escaped)},
               {"height [m]", m.height}});
}

// The median over the rounds of the ratio of two contestants' times.
double ratio(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> ratios;
    for (std::size_t i = 0; i < a.size(); ++i)
        ratios.push_back(a[i] / b[i]);
    return median(ratios);
}

void compare(Bench& bench, const std::vector<Contestant>& all, const std::vector<Outcome>& outcomes,
             int cubes)
{
    const std::string pile = ", " + std::to_string(cubes) + " cubes";
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].engine != "rigor") continue;
        const std::string ours = pile + " " + all[i].mode;
        bench.reach({"cubes of ours that left the room" + ours,
                     static_cast<double>(outcomes[i].measure.escaped), 0, "lower"});
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (all[k].engine != "bullet" || all[k].mode != all[i].mode) continue;
            bench.reach({"our time a step over Bullet's" + ours,
                         ratio(outcomes[i].means, outcomes[k].means), 1, "lower"});
            bench.reach({"our mean penetration over Bullet's" + ours,
                         outcomes[i].measure.mean / outcomes[k].measure.mean, 1, "lower"});
        }
    }
}

bool all_sleep(const World& world)
{
    return std::all_of(world.bodies.begin(), world.bodies.end(),
                       [](const RigidBody& body) { return body.is_still(); });
}

// A pile that comes to rest with sleep allowed and is then stepped with and without sleep.
void settle(Bench& bench, int side)
{
    constexpr int most = 3600, stretch = 30, rounds = 5;
    const PileStart start = pile_start(side);
    World sleeping = pile_world(start, {most, 1, true});
    for (int i = 0; !all_sleep(sleeping) && i < most; ++i)
        step(sleeping, pile_step);
    const double settled = sleeping.time;
    World awake = sleeping;
    awake.settings.optimisations.sleep = false;
    for (RigidBody& body : awake.bodies)
        body.rest = {};
    const auto some_steps = [](World& world) {
        for (int i = 0; i < stretch; ++i)
            step(world, pile_step);
    };
    const std::uint64_t before = sleeping.counters.bodies_asleep;
    some_steps(sleeping);
    const double asleep = static_cast<double>(sleeping.counters.bodies_asleep - before) /
                          (stretch * static_cast<double>(start.cubes.size()));
    const auto [with, without] =
        paired_seconds([&] { some_steps(sleeping); }, [&] { some_steps(awake); }, rounds);
    bench.row({{"asleep after [s]", settled},
               {"cubes ", static_cast<double>(start.cubes.size())},
               {"asleep", asleep},
               {"may sleep [ms a step]", with / stretch * 1e3},
               {"kept awake [ms a step]", without / stretch * 1e3}});
    bench.reach(
        {"speed of a settled pile that sleeps over one kept awake", without / with, 5, "higher"});
}

void use_threads(Bench& bench, int side, const PileChoice& choice)
{
    const PileStart start = pile_start(side);
    std::vector<double> one, two;
    for (int round = 0; round < choice.rounds; ++round)
        for (int threads : {1, 2}) {
            const PileRun run = in_fresh_process([&] {
                return pile_rigor(start, {choice.steps, threads, false});
            });
            (threads == 1 ? one : two).push_back(mean_ms(run.step_seconds));
        }
    bench.row({{"cubes", static_cast<double>(start.cubes.size())},
               {"one thread [ms]", median(one)},
               {"two threads [ms]", median(two)}});
    bench.reach({"speed of two threads over one, " + std::to_string(start.cubes.size()) +
                     " cubes kept awake",
                 ratio(one, two), 1.5, "higher"});
}

void explain(Bench& bench, const PileChoice& choice)
{
    bench.note("Unit cubes of 1000 kg from a grid into an open box, h = 1/60 s, " +
               std::to_string(choice.steps) +
               " steps, restitution 0, friction 0.5, one thread, each run in a process of");
    bench.note("its own, in turns; times are medians of " + std::to_string(choice.rounds) +
               " rounds. Depths: at the end, over all pairs closer than 1 cm, for every engine by");
    bench.note(
        "the same measure (the shortest way that parts two boxes). Bullet and ODE with their "
        "defaults; ODE's quick step. ODE does not put");
    bench.note("bodies to sleep unless it is told to.");
}

int run(const PileChoice& choice)
{
    Bench bench("pile");
    std::vector<Contestant> all = contestants();
    note_missing_engines(bench, all);
    std::erase_if(all, [&](const Contestant& c) { return !choice.wants(c.engine); });
    if (all.empty())
        throw std::invalid_argument("--engine: expected rigor, or bullet or ode if installed");
    for (int side : choice.does("cubes") ? choice.sides : std::vector<int>()) {
        const int cubes = side * side * side;
        const std::vector<Outcome> outcomes = measure(all, side, choice);
        for (std::size_t c = 0; c < all.size(); ++c)
            report(bench, all[c], cubes, outcomes[c]);
        compare(bench, all, outcomes, cubes);
    }
    if (choice.wants("rigor")) {
        if (choice.does("settled")) settle(bench, choice.sides.front());
        for (int side : choice.does("threads") ? choice.sides : std::vector<int>())
            use_threads(bench, side, choice);
        if (choice.does("nonconvex")) measure_nonconvex_piles(bench);
    }
    explain(bench, choice);
    return bench.finish(choice.json);
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(pile_choice(argc, argv));
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
