// SPDX-License-Identifier: MIT
#include "rigid/collisions.hpp"

#include "formulas/collision.hpp"
#include "rigid/optimised_forms.hpp"

#include <algorithm>
#include <stdexcept>

namespace rigor {

namespace {

constexpr int most_sweeps = 10, most_rounds = 4;
constexpr double as_deep = 0.9; // of the deepest

// The points of a pair that a collision may happen at now.
struct Candidates {
    std::vector<ContactPoint> points;
    std::vector<int> contacts; // their indices in the problem
    bool any_approaches = false;
};

void collect(const ContactProblem& problem, const ContactPair& pair, Candidates& candidates)
{
    candidates.points.clear();
    candidates.contacts.clear();
    candidates.any_approaches = false;
    for (int i = pair.first; i < pair.last; ++i) {
        const SolvedContact& c = problem.contacts[i];
        if (c.restitution == 0 && problem.method == ContactMethod::simultaneous) continue;
        const Vector3d v = problem.velocity_at(c, c.point);
        const double v_n = v.dot(c.normal);
        const double depth = -problem.predicted_gap(c, v_n + c.force_speed);
        if (!(depth > 0)) continue;
        // Thrown up with -v_n against the acceleration force_speed/h it is back after 2 v_n/force_speed
        // steps.
        const bool is_over_in_the_step = v_n < 0 && 2 * v_n > c.force_speed;
        if (is_over_in_the_step) continue;
        candidates.points.push_back({c.point, c.normal, depth, v});
        candidates.contacts.push_back(i);
        candidates.any_approaches |= v_n < 0;
    }
}

// The index that the formula chose, if it is one.
int checked(int index, std::size_t size)
{
    if (index < 0 || static_cast<std::size_t>(index) >= size)
        throw std::out_of_range("deepest_approaching_point returned " + std::to_string(index) +
                                " for " + std::to_string(size) + " contacts");
    return index;
}

// With restitution and friction together, Newton's law may give a body more energy than it had (Kane and
// Levinson 1985, "Dynamics: theory and applications"): ΔE = j·v + ½ jᵀKj. Such an impulse is shortened until
// it gives none.
Vector3d without_gain(const Matrix3d& K, const Vector3d& v, const Vector3d& j)
{
    const double work = j.dot(v), stored = j.dot(optimised::product(K, j)) / 2;
    if (!(work + stored > 1e-12 * stored)) return j; // no number is reported as such
    return std::max(0.0, -work / stored) * j;
}

// Bounces the pair once, at its deepest approaching point and those as deep. Whether it did.
bool bounce(ContactProblem& problem, const Candidates& candidates)
{
    const std::optional<int> deepest = deepest_approaching_point(candidates.points);
    if (!deepest) return false;
    const ContactPoint& chosen = candidates.points[checked(*deepest, candidates.points.size())];

    std::vector<int> together;
    Vector3d x = Vector3d::Zero();
    for (std::size_t k = 0; k < candidates.points.size(); ++k) {
        const ContactPoint& p = candidates.points[k];
        const bool is_alike =
            p.depth >= as_deep * chosen.depth && p.depth * as_deep <= chosen.depth &&
            p.normal.dot(chosen.normal) > 1 - 1e-9 && p.relative_velocity.dot(p.normal) < 0;
        if (!is_alike && &p != &chosen) continue;
        together.push_back(candidates.contacts[k]);
        x += p.point;
    }
    const double count = static_cast<double>(together.size());
    const SolvedContact& c = problem.contacts[together.front()];
    const bool is_alone = together.size() == 1;
    if (!is_alone) x /= count;
    const Matrix3d K = is_alone ? c.K : problem.impulse_matrix_at(c, x);
    const Vector3d v = is_alone ? chosen.relative_velocity : problem.velocity_at(c, x);
    Vector3d j = collision_impulse(K, v, chosen.normal, c.restitution, c.friction);
    if (c.restitution > 0 && c.friction > 0) j = without_gain(K, v, j);
    if (j.isZero(0)) return false;

    problem.apply(c, x, j);
    ++problem.counters->collision_impulses;
    for (int i : together)
        problem.contacts[i].bounce += j / count;
    return true;
}

} // namespace

void process_collisions(ContactProblem& problem, const Island& island)
{
    Candidates candidates;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        bool bounced = false;
        for (const ContactPair& pair : island.pairs)
            for (int round = 0; round < most_rounds; ++round) {
                collect(problem, pair, candidates);
                if (!candidates.any_approaches || !bounce(problem, candidates)) break;
                bounced = true;
            }
        if (!bounced) return;
    }
}

} // namespace rigor
