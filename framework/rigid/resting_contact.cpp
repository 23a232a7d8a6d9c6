// SPDX-License-Identifier: MIT
#include "rigid/resting_contact.hpp"

#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr int work = 4000, fewest_sweeps = 10, most_sweeps = 500; // contacts × sweeps an island

// nᵀKn along the normal and the larger tangential eigenvalue across it.
struct Stiffness {
    double normal = 0, tangential = 0;

    Matrix3d matrix(const Vector3d& n) const
    {
        return tangential * Matrix3d::Identity() + (normal - tangential) * n * n.transpose();
    }
};

Stiffness decoupled(const Matrix3d& K, const Vector3d& n)
{
    const Vector3d t = n.unitOrthogonal(), b = n.cross(t);
    const double tt = t.dot(K * t), bb = b.dot(K * b), tb = t.dot(K * b);
    return {n.dot(K * n), (tt + bb) / 2 + std::hypot((tt - bb) / 2, tb)};
}

// A contact's part of the work that stays the same from sweep to sweep.
struct Held {
    int contact = 0;
    Matrix3d K = Matrix3d::Zero(); // K̃
    double target = 0;             // v·n at the end of the stage [m/s]
    double speed = 0;              // nᵀKn times the impulse: the unit of convergence
};

// Corrects one contact's impulse. @return the velocity by which it changed, and all it amounts to
std::pair<double, double> hold(ContactProblem& problem, const Held& held)
{
    SolvedContact& c = problem.contacts[held.contact];
    const Vector3d& n = c.normal;
    Vector3d v = problem.velocity_at(c, c.point) - held.target * n;
    const bool is_idle = c.holding.isZero(0);
    if (is_idle && v.dot(n) >= 0) return {0, 0};

    if (!is_idle) v -= held.K * c.holding;
    const Vector3d j = collision_impulse(held.K, v, n, 0, c.friction);
    const Vector3d change = j - c.holding;
    if (!change.isZero(0)) {
        problem.apply(c, c.point, change);
        c.holding = j;
        ++problem.counters->contact_impulses;
    }
    return {held.speed * change.norm(), held.speed * j.norm()};
}

std::vector<Held> prepare(const ContactProblem& problem, const Island& island)
{
    std::vector<Held> all;
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            const SolvedContact& c = problem.contacts[i];
            const Stiffness k = decoupled(c.K, c.normal);
            if (!(k.normal > 0) || !(k.tangential > 0)) continue; // not a K of anything that moves
            all.push_back({i, k.matrix(c.normal),
                           c.gap > 0 ? -c.gap / problem.time_step : c.recovery, k.normal});
        }
    return all;
}

} // namespace

void process_contact(ContactProblem& problem, const Island& island)
{
    std::vector<Held> all = prepare(problem, island);
    if (all.empty()) return;
    const int sweeps = std::clamp(work / static_cast<int>(all.size()), fewest_sweeps, most_sweeps);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double change = 0, total = 0;
        for (const Held& held : all) {
            const auto [by, of] = hold(problem, held);
            change = std::max(change, by);
            total = std::max(total, of);
        }
        if (change <= std::numeric_limits<double>::epsilon() * total) return;
        std::reverse(all.begin(), all.end());
    }
}

} // namespace rigor
