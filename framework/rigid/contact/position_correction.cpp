// SPDX-License-Identifier: MIT
// Position correction by pseudo velocities (Catto 2014; also known as split impulses): projected
// Gauss–Seidel on displacements, with the impulse matrices of the step. In each island the code
// makes a row (`CorrectionRow`) for each contact that penetrates, or that the corrections could
// make penetrate. It then sweeps over the rows as the contact solver does, with displacements in
// place of velocities. In a world without gravity, the contact stage corrects penetration instead,
// by a target speed (`correction_speed`, Baumgarte 1972).
#include "rigid/contact/position_correction.hpp"

#include "rigid/bodies/two_bodies.hpp"
#include "rigid/contact/blocks.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace rigor {

namespace {

// `corrected_fraction` is the share of the overlap above the slop that a step removes.
// `correction_rate` is the highest speed of this correction, divided by the contact's radius [1/s].
// Larger values remove penetration sooner, but then piles jitter and bodies that overlap deeply
// jump apart. A fifth is the usual share in engines (0.2 in Box2D, Bullet and ODE); the rate was
// chosen by trial.
constexpr double corrected_fraction = 0.2;
constexpr double correction_rate = 1;
// The slop, which is the overlap that the correction leaves, divided by the contact's radius. In a
// stack it is only as large as numerical errors; a pile would not come to rest without `pile_slop`.
constexpr double stack_slop = 1e-6, pile_slop = penetration_slop;
// The slop in worlds without gravity, also as a fraction of the radius. It is larger than the other
// two because corrections add energy in such worlds.
constexpr double weightless_slop = 1e-3;
// All sweeps over an island together visit about `most_visits` rows, but there are always at least
// `fewest_sweeps` and at most `most_sweeps` sweeps. More sweeps take more time; with fewer sweeps,
// more overlap of a large island is left to the next steps. Chosen by trial; `bench pile` shows the
// time and the overlap.
constexpr int most_visits = 2000, fewest_sweeps = 4, most_sweeps = 20;

using namespace optimised;

// A contact in the position correction: its normal, the distance by which its bodies have to move
// apart along the normal, and the data from which a correction computes the displacements.
struct CorrectionRow {
    int body1 = 0, body2 = 0;
    Vector3d n;
    Two inverse_mass;            // 1/M₁ and -1/M₂ [1/kg]
    TwoVectors torque;           // r₁ × n and r₂ × n [m]
    TwoVectors turn;             // I₁⁻¹ (r₁ × n) and -I₂⁻¹ (r₂ × n) [1/(kg m)]
    double inverse_normal_K = 0; // 1/(nᵀKn) [kg]
    double distance = 0;         // the gap must grow by this, or may shrink by -distance [m]
    double correction = 0;       // sum of the corrections so far, ≥ 0 [kg m]
};

// The rows for the contacts in a block of an island (blocks.hpp), and how many of these contacts
// penetrate.
struct Rows {
    std::vector<CorrectionRow> all;
    std::uint64_t penetrating = 0;
    bool needs_correction = false; // whether any contact needs a correction
};

CorrectionRow row_of(const ContactProblem& problem, const ContactConstraint& c,
                     const TwoMasses& masses, double distance)
{
    const Body &body1 = problem.bodies[c.body1], &body2 = problem.bodies[c.body2];
    const TwoVectors levers = side_by_side(c.point - body1.position, c.point - body2.position);
    const TwoVectors torque = cross(levers, broadcast(c.normal));
    return {c.body1,
            c.body2,
            c.normal,
            masses.inverse_mass,
            torque,
            inverse_inertia_times(masses, torque),
            1 / c.normal_K,
            distance,
            0};
}

Rows rows_of(const ContactProblem& problem, const Island& island, const IndexRange& block,
             double slop)
{
    const double h = problem.time_step;
    Rows rows;
    std::size_t most = 0;
    for (int k = block.first; k < block.last; ++k)
        most += island.pairs[k].count();
    rows.all.reserve(most);
    for (int k = block.first; k < block.last; ++k) {
        const ContactConstraint& lowest = problem.contacts[island.pairs[k].first];
        const TwoMasses masses(problem.bodies[lowest.body1], problem.bodies[lowest.body2]);
        for (int i = island.pairs[k].first; i < island.pairs[k].last; ++i) {
            const ContactConstraint& c = problem.contacts[i];
            if (!(c.normal_K > 0)) continue;
            const double v_n = problem.velocity_at(c, c.point).dot(c.normal);
            const double gap = problem.predicted_gap(c, v_n);
            const double radius = c.radius;
            if (gap > correction_rate * radius * h) continue; // no correction is this large
            double distance = -gap;
            if (gap < 0) {
                const double excess = -gap - slop * radius;
                // An overlap below twice the slop is not corrected. Otherwise corrections would
                // never end.
                const bool is_corrected = excess > slop * radius;
                rows.needs_correction |= is_corrected;
                distance = is_corrected
                               ? std::min(corrected_fraction * excess, correction_rate * radius * h)
                               : 0;
                ++rows.penetrating;
            }
            rows.all.push_back(row_of(problem, c, masses, distance));
        }
    }
    return rows;
}

// Updates the correction of one contact, while the corrections of all other contacts stay as they
// are. `d` holds the displacements of both bodies, in place of their velocities.
[[gnu::always_inline]] inline void correct(CorrectionRow& row, TwoMotions& d)
{
    const TwoVectors n = broadcast(row.n);
    const Two apart = dot(n, d.V) + dot(row.torque, d.w);
    const double missing = row.distance - (apart[0] - apart[1]);
    const double needed = std::max(0.0, row.correction + missing * row.inverse_normal_K);
    const double p = needed - row.correction;
    row.correction = needed;
    const Two both{p, p};
    const Two& m = row.inverse_mass;
    d.V += {both * (m * n.x), both * (m * n.y), both * (m * n.z)};
    d.w += {both * row.turn.x, both * row.turn.y, both * row.turn.z};
}

void sweep(const ContactProblem& problem, std::vector<CorrectionRow>& rows,
           std::vector<Displacement>& displacements)
{
    for (std::size_t first = 0, last = 0; first < rows.size(); first = last) {
        const auto [body1, body2] = std::pair(rows[first].body1, rows[first].body2);
        Displacement &d1 = displacements[body1], &d2 = displacements[body2];
        TwoMotions d{side_by_side(d1.shift, d2.shift), side_by_side(d1.turn, d2.turn)};
        for (; last < rows.size() && rows[last].body1 == body1 && rows[last].body2 == body2; ++last)
            correct(rows[last], d);
        if (!problem.bodies[body1].is_static()) d1 = {of_first(d.V), of_first(d.w)};
        if (!problem.bodies[body2].is_static()) d2 = {of_second(d.V), of_second(d.w)};
    }
}

} // namespace

double correction_speed(const ContactProblem& problem, const ContactConstraint& c)
{
    const double excess = -c.gap - weightless_slop * c.radius;
    if (!problem.settings.gravity.isZero(0) || excess <= 0) return 0;
    return std::min(corrected_fraction * excess / problem.time_step, correction_rate * c.radius);
}

namespace {

void correct(const ContactProblem& problem, const Island& island,
             std::vector<Displacement>& displacements)
{
    std::vector<Rows> rows(island.blocks.size());
    const double slop = is_pile(island) ? pile_slop : stack_slop;
    problem.pool->for_each_task(static_cast<int>(rows.size()), [&](int k) {
        rows[k] = rows_of(problem, island, island.blocks[k], slop);
    });
    std::size_t count = 0;
    bool any = false;
    for (const Rows& of_block : rows) {
        count += of_block.all.size();
        any |= of_block.needs_correction;
        problem.counters->corrected_contacts += of_block.penetrating;
    }
    if (!any) return;
    displacements.resize(problem.bodies.size());
    const int sweeps =
        std::clamp(most_visits / static_cast<int>(count), fewest_sweeps, most_sweeps);
    for (int i = 0; i < sweeps; ++i)
        visit_blocks(island, *problem.pool,
                     [&](int k) { sweep(problem, rows[k].all, displacements); });
}

} // namespace

std::vector<Displacement> position_corrections(const ContactProblem& problem)
{
    std::vector<Displacement> displacements;
    if (problem.settings.gravity.isZero(0)) return displacements;
    for (const Island& island : problem.islands)
        correct(problem, island, displacements);
    return displacements;
}

} // namespace rigor
