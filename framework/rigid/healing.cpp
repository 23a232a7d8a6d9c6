// SPDX-License-Identifier: MIT
#include "rigid/healing.hpp"

#include "rigid/optimised_forms.hpp"

#include <algorithm>

namespace rigor {

namespace {

constexpr double healed_fraction = 0.2, healing_rate = 1 /* 1/s */;
constexpr double seen_fraction = 1e-3, rounding_fraction = 1e-6; // of the radius
constexpr int work = 2000, fewest_sweeps = 4, most_sweeps = 20;

// A contact's normal, and how far its bodies have to move apart along it.
struct Row {
    int body1 = 0, body2 = 0;
    Vector3d n, r1, r2;
    double per_normal_K = 0;
    double distance = 0; // at least; negative: they may come as much nearer [m]
    double push = 0;     // the sum so far, ≥ 0 [kg m]
};

// Rows of the contacts, none if nothing needs healing.
std::vector<Row> rows_of(const ContactProblem& problem, const Island& island)
{
    const double h = problem.time_step;
    std::vector<Row> rows;
    bool any = false;
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            const SolvedContact& c = problem.contacts[i];
            if (!(c.normal_K > 0)) continue;
            const double v_n = problem.velocity_at(c, c.point).dot(c.normal);
            const double gap = problem.predicted_gap(c, v_n);
            const double radius = c.radius;
            if (gap > healing_rate * radius * h) continue; // nothing could close it
            double distance = -gap;
            if (gap < 0) {
                const double excess = -gap - rounding_fraction * radius;
                any |= excess > 0;
                distance = std::clamp(healed_fraction * excess, 0.0, healing_rate * radius * h);
                ++problem.counters->healed_contacts;
            }
            rows.push_back({c.body1, c.body2, c.normal, c.point - problem.bodies[c.body1].position,
                            c.point - problem.bodies[c.body2].position, 1 / c.normal_K, distance,
                            0});
        }
    if (!any) rows.clear();
    return rows;
}

void push(const Body& body, Displacement& d, const Vector3d& r, const Vector3d& p)
{
    d.shift += body.inverse_mass * p;
    d.turn += optimised::product(body.inverse_inertia, r.cross(p));
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
    std::vector<Row> rows = rows_of(problem, island);
    if (rows.empty()) return;
    displacements.resize(problem.bodies.size());
    const int sweeps = std::clamp(work / static_cast<int>(rows.size()), fewest_sweeps, most_sweeps);
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (Row& row : rows) {
            Displacement &d1 = displacements[row.body1], &d2 = displacements[row.body2];
            const Vector3d d = d1.shift + d1.turn.cross(row.r1) - d2.shift - d2.turn.cross(row.r2);
            const double needed =
                std::max(0.0, row.push + (row.distance - d.dot(row.n)) * row.per_normal_K);
            if (needed == row.push) continue;
            const Vector3d p = (needed - row.push) * row.n;
            row.push = needed;
            push(problem.bodies[row.body1], d1, row.r1, p);
            push(problem.bodies[row.body2], d2, row.r2, -p);
        }
}

} // namespace rigor
