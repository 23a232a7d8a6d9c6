// SPDX-License-Identifier: MIT
// Compares the change of the velocities that impulses make, and the least change that the law of
// contact needs, with the speeds before the impulses. See far_from_law.hpp.
#include "rigid/contact/solvers/far_from_law.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

// The largest changes of the velocities, as multiples of that of a body with the mass of the whole
// island that stops from the speed a. Where driven bodies push, a is the approach: two smooth
// planes that close in on a body at the angle α drive it out with 1/tan α times their speed, 5
// times at 11°. A mesh between parallel planes should stay, but its normals are off by up to 2°.
// Where the bodies may rest, impulses lose energy, but a body that flies past may have much more
// energy than its approach shows; so a is the highest speed. Chosen by trial; tests/classics has
// gears, and meshes between plates, and the toy box of assignment A5 must not get here.
constexpr double most_if_pushed = 5, most_if_resting = 10;

// The change of the velocities V and ω of a body [m/s], [1/s].
struct Motion {
    Vector3d V = Vector3d::Zero(), w = Vector3d::Zero();
};

// The changes of the velocities, and what the law of contact still misses.
struct Change {
    std::vector<Motion> motions; // one for each body of the problem
    double squared = 0;          // |Δv|² [J]
    double missing = 0;          // Σ jₙ (s - vₙ) [J]

    Vector3d at(const ContactProblem& problem, int body, const Vector3d& x) const
    {
        const auto& [V, w] = motions[body];
        return V + w.cross(x - problem.bodies[body].position);
    }
};

Change change_by(const ContactProblem& problem, const Island& island, std::span<const int> active,
                 const std::vector<Vector3d>& impulses)
{
    Change change{std::vector<Motion>(problem.bodies.size()), 0, 0};
    // First V is the sum of the impulses on a body, and w that of their moments.
    for (std::size_t k = 0; k < active.size(); ++k) {
        const Vector3d& j = impulses[k];
        if (j.isZero(0)) continue;
        const ContactConstraint& c = problem.contacts[active[k]];
        const double v_n = problem.velocity_at(c, c.point).dot(c.normal);
        change.missing += j.dot(c.normal) * (c.target_speed - v_n);
        for (const auto& [i, sign] : {std::pair(c.body1, 1.0), std::pair(c.body2, -1.0)}) {
            if (problem.bodies[i].is_static()) continue;
            change.motions[i].V += sign * j;
            change.motions[i].w += sign * (c.point - problem.bodies[i].position).cross(j);
        }
    }
    for (const int i : island.bodies) {
        const Body& body = problem.bodies[i];
        auto& [V, w] = change.motions[i];
        const Vector3d P = V, L = w;
        V = body.inverse_mass * P;
        w = body.inverse_inertia * L;
        change.squared += P.dot(V) + L.dot(w);
    }
    return change;
}

// The highest speed |J (v - Δv) - s n| of a contact that has an impulse [m/s].
double fastest_before(const ContactProblem& problem, std::span<const int> active,
                      const std::vector<Vector3d>& impulses, const Change& change)
{
    double fastest = 0;
    for (std::size_t k = 0; k < active.size(); ++k) {
        if (impulses[k].isZero(0)) continue;
        const ContactConstraint& c = problem.contacts[active[k]];
        const Vector3d by_impulses =
            change.at(problem, c.body1, c.point) - change.at(problem, c.body2, c.point);
        const Vector3d before = problem.velocity_at(c, c.point) - by_impulses;
        fastest = std::max(fastest, (before - c.target_speed * c.normal).norm());
    }
    return fastest;
}

// Whether the bodies of the island may all rest relative to the first of its grounds
// (`ContactProblem::grounds_of`), because no other ground pushes them. Then there is no jam. A
// target speed above 0 pushes only where it corrects penetration, which is in worlds without
// gravity.
bool may_rest(const ContactProblem& problem, const Island& island, std::span<const int> active)
{
    const Body ground = problem.grounds_of(island).front();
    const bool corrects = problem.settings.gravity.isZero(0);
    return std::all_of(active.begin(), active.end(), [&](int i) {
        const ContactConstraint& c = problem.contacts[i];
        Vector3d v = Vector3d::Zero();
        for (const auto& [body, sign] : {std::pair(c.body1, 1.0), std::pair(c.body2, -1.0)}) {
            const Body& b = problem.bodies[body];
            if (!b.is_static()) continue;
            v += sign *
                 (b.velocity - ground.velocity + b.angular_velocity.cross(c.point - b.position));
        }
        const double least = corrects ? c.target_speed : std::min(c.target_speed, 0.0);
        return v.dot(c.normal) >= least - problem.rounding_speed(c);
    });
}

} // namespace

bool is_far_from_law(const ContactProblem& problem, const Island& island,
                     std::span<const int> active, const std::vector<Vector3d>& impulses,
                     double approach)
{
    const Change change = change_by(problem, island, active, impulses);
    double M = 0;
    for (const int i : island.bodies)
        M += 1 / problem.bodies[i].inverse_mass;
    // |Δv|² + Σ jₙ (s - vₙ) > c √M a |Δv|
    const auto is_far = [&](double most, double a) {
        return change.squared + std::max(change.missing, 0.0) >
               most * std::sqrt(M * change.squared) * a;
    };
    if (!is_far(most_if_pushed, approach)) return false;
    if (!may_rest(problem, island, active)) return true;
    const double speed = fastest_before(problem, active, impulses, change);
    return is_far(most_if_resting, std::max(approach, speed));
}

} // namespace rigor
