// SPDX-License-Identifier: MIT
#include "rigid/healing.hpp"

#include "rigid/blocks.hpp"
#include "rigid/two_bodies.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace rigor {

namespace {

constexpr double healed_fraction = 0.2, healing_rate = 1 /* 1/s */;
constexpr double seen_fraction = 1e-3, left_fraction = 1e-6, left_in_a_heap = 1e-4; // of the radius
constexpr int work = 2000, fewest_sweeps = 4, most_sweeps = 20;

using namespace optimised;

// A contact's normal, how far its bodies have to move apart along it, and what a push along it does.
struct Row {
    int body1 = 0, body2 = 0;
    Vector3d n;
    Two inverse_mass;
    TwoVectors torque, turn; // r × n, and what that turns
    double per_normal_K = 0;
    double distance = 0; // at least; negative: they may come as much nearer [m]
    double push = 0;     // the sum so far, ≥ 0 [kg m]
};

// Rows of the contacts of a block.
struct Rows {
    std::vector<Row> all;
    std::uint64_t penetrating = 0;
    bool any = false; // needs healing
};

Row row_of(const ContactProblem& problem, const SolvedContact& c, const TwoMasses& masses,
           double distance)
{
    const Body &body1 = problem.bodies[c.body1], &body2 = problem.bodies[c.body2];
    const TwoVectors levers = side_by_side(c.point - body1.position, c.point - body2.position);
    const TwoVectors torque = cross(levers, twice(c.normal));
    return {
        c.body1,        c.body2,  c.normal, masses.inverse_mass, torque, turned_by(masses, torque),
        1 / c.normal_K, distance, 0};
}

Rows rows_of(const ContactProblem& problem, const Island& island, const IslandStretch& block,
             double left)
{
    const double h = problem.time_step;
    Rows rows;
    std::size_t most = 0;
    for (int k = block.first; k < block.last; ++k)
        most += island.pairs[k].count();
    rows.all.reserve(most);
    for (int k = block.first; k < block.last; ++k) {
        const SolvedContact& lowest = problem.contacts[island.pairs[k].first];
        const TwoMasses masses(problem.bodies[lowest.body1], problem.bodies[lowest.body2]);
        for (int i = island.pairs[k].first; i < island.pairs[k].last; ++i) {
            const SolvedContact& c = problem.contacts[i];
            if (!(c.normal_K > 0)) continue;
            const double v_n = problem.velocity_at(c, c.point).dot(c.normal);
            const double gap = problem.predicted_gap(c, v_n);
            const double radius = c.radius;
            if (gap > healing_rate * radius * h) continue; // nothing could close it
            double distance = -gap;
            if (gap < 0) {
                const double excess = -gap - left * radius;
                const bool heals = excess > left * radius; // so that it comes to an end
                rows.any |= heals;
                distance =
                    heals ? std::min(healed_fraction * excess, healing_rate * radius * h) : 0;
                ++rows.penetrating;
            }
            rows.all.push_back(row_of(problem, c, masses, distance));
        }
    }
    return rows;
}

// One contact's law, with all the others in place. Displacements stand where velocities do.
[[gnu::always_inline]] inline void push_apart(Row& row, TwoMotions& d)
{
    const TwoVectors n = twice(row.n);
    const Two apart = dot(n, d.V) + dot(row.torque, d.w);
    const double missing = row.distance - (apart[0] - apart[1]);
    const double needed = std::max(0.0, row.push + missing * row.per_normal_K);
    const double p = needed - row.push;
    row.push = needed;
    const Two both{p, p};
    const Two& m = row.inverse_mass;
    d.V += {both * (m * n.x), both * (m * n.y), both * (m * n.z)};
    d.w += {both * row.turn.x, both * row.turn.y, both * row.turn.z};
}

void sweep(const ContactProblem& problem, std::vector<Row>& rows,
           std::vector<Displacement>& displacements)
{
    for (std::size_t first = 0, last = 0; first < rows.size(); first = last) {
        const auto [body1, body2] = std::pair(rows[first].body1, rows[first].body2);
        Displacement &d1 = displacements[body1], &d2 = displacements[body2];
        TwoMotions d{side_by_side(d1.shift, d2.shift), side_by_side(d1.turn, d2.turn)};
        for (; last < rows.size() && rows[last].body1 == body1 && rows[last].body2 == body2; ++last)
            push_apart(rows[last], d);
        if (!problem.bodies[body1].is_static()) d1 = {of_first(d.V), of_first(d.w)};
        if (!problem.bodies[body2].is_static()) d2 = {of_second(d.V), of_second(d.w)};
    }
}

} // namespace

double healing_speed(const ContactProblem& problem, const SolvedContact& c)
{
    const double excess = -c.gap - seen_fraction * c.radius;
    if (!problem.gravity.isZero(0) || excess <= 0) return 0;
    return std::min(healed_fraction * excess / problem.time_step, healing_rate * c.radius);
}

void heal(const ContactProblem& problem, const Island& island,
          std::vector<Displacement>& displacements)
{
    if (problem.gravity.isZero(0)) return;
    std::vector<Rows> rows(island.blocks.size());
    const double left = is_heap(island) ? left_in_a_heap : left_fraction;
    problem.team->share(static_cast<int>(rows.size()),
                        [&](int k) { rows[k] = rows_of(problem, island, island.blocks[k], left); });
    std::size_t count = 0;
    bool any = false;
    for (const Rows& of_block : rows) {
        count += of_block.all.size();
        any |= of_block.any;
        problem.counters->healed_contacts += of_block.penetrating;
    }
    if (!any) return;
    displacements.resize(problem.bodies.size());
    const int sweeps = std::clamp(work / static_cast<int>(count), fewest_sweeps, most_sweeps);
    for (int i = 0; i < sweeps; ++i)
        visit_blocks(island, *problem.team,
                     [&](int k) { sweep(problem, rows[k].all, displacements); });
}

} // namespace rigor
