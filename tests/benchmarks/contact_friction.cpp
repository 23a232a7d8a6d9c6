// SPDX-License-Identifier: MIT
// A block on an incline: the angle from which it slips, and how it creeps below.
#include "contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

constexpr double most_creep = 1e-6; // of a block that sticks, in 10 s [m]
constexpr double frictions[] = {0.1, 0.5, 1};

double limit_of(double friction) // tan θ = μ [degrees]
{
    return std::atan(friction) * 180 / std::numbers::pi;
}

// How far a block creeps in 10 s, starting at rest [m].
double creep(const Contestant& contestant, double degrees, double friction)
{
    const Trial trial = block_on_incline(degrees, friction);
    const std::unique_ptr<TrialEngine> engine = contestant.start(trial);
    const long steps = std::lround(contact_end / contact_step);
    for (long i = 0; i < steps; ++i)
        engine->step(contact_step);
    return std::abs(way_down(trial, engine->motion(0)));
}

// Where sticking ends: the block sticks at `sticks` and slips at `slips`, 1e-4 degrees apart.
struct Bracket {
    double sticks = 0, slips = 0; // [degrees]
};

Bracket bisect(const Contestant& contestant, double friction)
{
    Bracket bracket = {0, limit_of(friction) + 2};
    if (creep(contestant, bracket.sticks, friction) > most_creep)
        return {0, 0}; // slips on the level
    while (bracket.slips - bracket.sticks > 1e-4) {
        const double middle = (bracket.sticks + bracket.slips) / 2;
        (creep(contestant, middle, friction) <= most_creep ? bracket.sticks : bracket.slips) =
            middle;
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
            const Bracket bracket = bisect(contestant, friction);
            const double off =
                std::max(std::abs(bracket.sticks - limit), std::abs(bracket.slips - limit));
            worst = std::max(worst, off);
            bench.row({{"block on an incline", contestant.name()},
                       {"friction", friction},
                       {"limit [°]", limit},
                       {"sticks up to [°]", bracket.sticks - limit},
                       {"slips from [°]", bracket.slips - limit},
                       {"creep 0.01° below [m]", creep(contestant, limit - 0.01, friction)},
                       {"way 0.01° above [m]", creep(contestant, limit + 0.01, friction)}});
        }
        if (contestant.is_ours())
            bench.reach({contestant.method + ": sticks or slips, off tan θ = μ by [degrees]", worst,
                         0.01, "lower"});
    }
    bench.note(
        "Block on an incline: it sticks if it creeps less than 1e-6 m in 10 s. The angles are "
        "bisected to 1e-4 degrees and given from the limit tan θ = μ.");
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
    bench.note("Creep: at parts of the limit's angle, the largest for friction 0.1, 0.5 and 1.");
}

} // namespace rigor
