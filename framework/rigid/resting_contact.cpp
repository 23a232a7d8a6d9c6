// SPDX-License-Identifier: MIT
#include "rigid/resting_contact.hpp"

#include "formulas/collision.hpp"
#include "rigid/load_guess.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

// An island of up to `small` contacts converges to rounding. A larger one stops at a thousandth of its
// largest impulse, or after `work` contacts were visited: what is left is corrected in the next steps.
constexpr int small = 16, work = 2000, fewest_sweeps = 10, most_sweeps = 500;
constexpr double rounding = 2 * std::numeric_limits<double>::epsilon(), thousandth = 1e-3;

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

// Corrects one contact's impulse. @return by how much
Vector3d hold(ContactProblem& problem, const Held& held)
{
    SolvedContact& c = problem.contacts[held.contact];
    const Vector3d& n = c.normal;
    Vector3d v = problem.velocity_at(c, c.point) - held.target * n;
    const bool is_idle = c.holding.isZero(0);
    if (is_idle && v.dot(n) >= 0) return Vector3d::Zero();

    if (!is_idle) v -= held.K * c.holding;
    const Vector3d j = collision_impulse(held.K, v, n, 0, c.friction);
    const Vector3d change = j - c.holding;
    if (change.isZero(0)) return change;
    problem.apply(c, c.point, change);
    c.holding = j;
    ++problem.counters->contact_impulses;
    return change;
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

// What a sweep changed: the largest change and impulse, as velocities, and the squared length of all
// changes.
struct Progress {
    double change = 0, total = 0, squared = 0;
};

// Visits each contact once. @return in `steps`, what it changed
Progress sweep(ContactProblem& problem, const std::vector<Held>& all, std::vector<Vector3d>& steps)
{
    Progress progress;
    for (std::size_t k = 0; k < all.size(); ++k) {
        steps[k] = hold(problem, all[k]);
        const double speed = all[k].speed;
        progress.change = std::max(progress.change, speed * steps[k].norm());
        progress.total =
            std::max(progress.total, speed * problem.contacts[all[k].contact].holding.norm());
        progress.squared += speed * steps[k].squaredNorm();
    }
    return progress;
}

// The fastest that anything moves at a contact: velocities cannot be told apart below its rounding [m/s].
double fastest(const ContactProblem& problem, const std::vector<Held>& all)
{
    double speed = 0;
    for (const Held& held : all) {
        const SolvedContact& c = problem.contacts[held.contact];
        for (int i : {c.body1, c.body2}) {
            const Body& b = problem.bodies[i];
            if (b.is_static()) continue;
            const double lever = (c.point - b.position).norm();
            speed = std::max(speed, b.velocity.norm() + b.angular_velocity.norm() * lever);
        }
    }
    return speed;
}

// Goes on in the direction of the sweeps before: directions = steps + β directions, impulses += β
// directions.
void extrapolate(ContactProblem& problem, const std::vector<Held>& all,
                 const std::vector<Vector3d>& steps, std::vector<Vector3d>& directions, double beta)
{
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Vector3d more = beta * directions[k];
        directions[k] = steps[k] + more;
        if (more.isZero(0)) continue;
        SolvedContact& c = problem.contacts[all[k].contact];
        problem.apply(c, c.point, more);
        c.holding += more;
    }
}

} // namespace

void process_contact(ContactProblem& problem, const Island& island)
{
    const std::vector<Held> all = prepare(problem, island);
    if (all.empty()) return;
    std::vector<int> contacts;
    for (const Held& held : all)
        contacts.push_back(held.contact);
    guess_loads(problem, island, contacts);

    const int count = static_cast<int>(all.size());
    const int sweeps = std::clamp(work / count, fewest_sweeps, most_sweeps);
    const double tolerance = count <= small ? rounding : thousandth;
    std::vector<Vector3d> steps(all.size(), Vector3d::Zero()), directions = steps;
    const double noise = rounding * fastest(problem, all);
    double before = 0;
    for (int i = 0; i < sweeps; ++i) {
        const Progress progress = sweep(problem, all, steps);
        if (progress.change <= tolerance * progress.total + noise) return;
        const bool slows_down = before > 0 && progress.squared <= before;
        const double beta = slows_down ? progress.squared / before : 0; // 0: starts afresh
        before = progress.squared;
        if (i + 1 < sweeps) extrapolate(problem, all, steps, directions, beta);
    }
}

} // namespace rigor
