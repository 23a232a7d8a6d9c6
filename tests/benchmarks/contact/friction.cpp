// SPDX-License-Identifier: MIT
// A block on an incline: the angle at which it starts to slip, found by bisection and compared with
// Coulomb's tan θ = μ, and the distance that it creeps below this angle.
#include "parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

constexpr double most_creep = 1e-6;             // largest creep of a block that sticks, in 10 s [m]
constexpr double clear_slip = 1e-2;             // a block that moves farther certainly slips [m]
constexpr double frictions[] = {0.1, 0.5, 0.8}; // a cube tips over for μ ≥ 1

// The angle from which a block slips, tan θ = μ [degrees].
double limit_of(double friction)
{
    return std::atan(friction) * 180 / std::numbers::pi;
}

// The distance that a block creeps in 10 s from rest [m].
double creep(const Contestant& contestant, double degrees, double friction)
{
    const Trial trial = block_on_incline(degrees, friction);
    const std::unique_ptr<TrialEngine> engine = contestant.start(trial);
    const long steps = std::lround(contact_end / contact_step);
    for (long i = 0; i < steps; ++i)
        engine->step(contact_step);
    return std::abs(way_down(trial, engine->motion(0)));
}

// Two angles, at most 1e-4 degrees apart: at the first a block creeps at most a given distance, at
// the second it moves farther [degrees].
struct Bracket {
    double below = 0, above = 0;
};

Bracket bisect(const Contestant& contestant, double friction, double most)
{
    Bracket bracket = {0, limit_of(friction) + 2};
    while (bracket.above - bracket.below > 1e-4) {
        const double middle = (bracket.below + bracket.above) / 2;
        (creep(contestant, middle, friction) <= most ? bracket.below : bracket.above) = middle;
    }
    return bracket;
}

} // namespace

void measure_stick_or_slip(Bench& bench, const std::vector<Contestant>& all)
{
    for (const Contestant& contestant : all) {
        double worst = 0;
        for (double friction : frictions) {
            const double limit = limit_of(friction);
            const Bracket sticks = bisect(contestant, friction, most_creep);
            const Bracket clear = bisect(contestant, friction, clear_slip);
            const double off =
                std::max(std::abs(sticks.below - limit), std::abs(sticks.above - limit));
            worst = std::max(worst, off);
            bench.row({{"block on an incline", contestant.name()},
                       {"friction", friction},
                       {"limit [°]", limit},
                       {"sticks up to [°]", sticks.below - limit},
                       {"slips from [°]", sticks.above - limit},
                       {"1 cm from [°]", clear.above - limit},
                       {"creep 0.01° below [m]", creep(contestant, limit - 0.01, friction)},
                       {"way 0.01° above [m]", creep(contestant, limit + 0.01, friction)}});
        }
        if (contestant.is_ours())
            bench.reach({contestant.method + ": sticks or slips, off tan θ = μ by [degrees]", worst,
                         0.01, "lower"});
    }
    bench.note("Block on an incline: it sticks if it creeps less than 1e-6 m in 10 s, its start "
               "included; 1 cm is for those that creep. The angles");
    bench.note("are bisected to 1e-4 degrees and given from the limit, tan θ = μ.");
}

void measure_creep(Bench& bench, const std::vector<Contestant>& all)
{
    for (const Contestant& contestant : all) {
        double worst = 0;
        Bench::Row row = {{"creep in 10 s [m]", contestant.name()}};
        for (double part : {0.1, 0.5, 0.9, 0.99}) {
            double most = 0;
            for (double friction : frictions)
                most = std::max(most, creep(contestant, part * limit_of(friction), friction));
            worst = std::max(worst, most);
            char key[32];
            std::snprintf(key, sizeof key, "at %g of the limit", part);
            row.emplace_back(key, most);
        }
        bench.row(std::move(row));
        if (contestant.is_ours())
            bench.reach({contestant.method + ": creep below the limit in 10 s [m]", worst,
                         most_creep, "lower"});
    }
    bench.note("Creep: at parts of the limit's angle, the largest for friction 0.1, 0.5 and 0.8.");
}

} // namespace rigor
