// SPDX-License-Identifier: MIT
// When the step of the whole world is divided: in the middle, or, if few bodies move, just after
// the first bounce.
#include "rigid/step/substeps/divisions.hpp"

#include "rigid/step/impact.hpp"

#include <algorithm>

namespace rigor {

namespace {

// The step of a whole world is halved at most this many times in a row, so it has at most 2⁶ parts.
// This bounds the run time if bodies fly about at high speeds, which wrong formulas may cause.
constexpr int most_halvings = 6;

} // namespace

bool is_small(const World& world)
{
    const auto moves = [](const RigidBody& body) { return !body.is_static; };
    return std::count_if(world.bodies.begin(), world.bodies.end(), moves) <=
           static_cast<std::ptrdiff_t>(few_bodies);
}

bool may_be_halved(const World& world, const Divisions& divisions)
{
    return (is_small(world) ? divisions.halvings : divisions.all()) < most_halvings;
}

double after_first_bounce(const World& world, const ContactProblem& problem,
                          const Divisions& divisions)
{
    if (!is_small(world) || divisions.all() >= most_divisions_of_few) return 0;
    for (const Island& island : problem.islands)
        for (const ContactPair& pair : island.pairs)
            if (carries_load(problem, pair) && !bounced(problem, pair)) return 0;
    const double time = first_bounce(world, problem) + alone_in_step * problem.time_step;
    return time < problem.time_step ? time : 0;
}

} // namespace rigor
