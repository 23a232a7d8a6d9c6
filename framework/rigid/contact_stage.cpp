// SPDX-License-Identifier: MIT
#include "rigid/contact_stage.hpp"

#include "rigid/contact_formulas.hpp"
#include "rigid/healing.hpp"
#include "rigid/load_guess.hpp"
#include "rigid/newton_contact.hpp"
#include "rigid/sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

// An island of up to `small` contacts converges to rounding. A larger one stops at `fine` or `coarse` of the
// velocity that its contacts have to take away, or after `work` contacts were visited: what is left is
// corrected in the next steps. A heap at rest is worth more exactness: what is left makes it creep, and it would
// never fall asleep.
constexpr int small = 16, work = 4000, fewest_sweeps = 5, most_sweeps = 50, last_sweeps = 20,
              times_at_rest = 3;
constexpr std::size_t large = 1000, few_bodies = 8;
constexpr double rounding = 2 * std::numeric_limits<double>::epsilon(), tiny = 1e-13, fine = 1e-8,
                 coarse = 1e-3, coarse_at_rest = 1e-4;

// The largest of value(held), at least 0.
template <class Value>
double largest(const ContactProblem& problem, std::span<const Held> all, const Value& value)
{
    const auto largest_of = [&](std::size_t first, std::size_t last) {
        double found = 0;
        for (std::size_t k = first; k < last; ++k)
            found = std::max(found, value(all[k]));
        return found;
    };
    constexpr std::size_t worth_sharing = 512; // contacts
    if (problem.team->stretches_of(all.size(), worth_sharing) < 2) return largest_of(0, all.size());
    const std::vector<double> found = problem.team->collect(all.size(), worth_sharing, largest_of);
    return *std::max_element(found.begin(), found.end());
}

// The fastest that anything moves at a contact: velocities cannot be told apart below its rounding [m/s].
double fastest(const ContactProblem& problem, const Island& island, std::span<const Held> all)
{
    std::vector<std::pair<double, double>> speeds(problem.bodies.size()); // |V|, |ω|
    for (int i : island.bodies)
        speeds[i] = {problem.bodies[i].velocity.norm(), problem.bodies[i].angular_velocity.norm()};
    return largest(problem, all, [&](const Held& held) {
        const SolvedContact& c = problem.contacts[held.contact];
        double speed = 0;
        for (int i : {c.body1, c.body2}) {
            const Body& b = problem.bodies[i];
            if (b.is_static()) continue;
            const double lever = (c.point - b.position).norm();
            speed = std::max(speed, speeds[i].first + speeds[i].second * lever);
        }
        return speed;
    });
}

// The fastest that a contact approaches: what the impulses are there to take away [m/s].
double approach(const ContactProblem& problem, std::span<const Held> all)
{
    return largest(problem, all, [&](const Held& held) {
        const SolvedContact& c = problem.contacts[held.contact];
        return held.target - problem.velocity_at(c, c.point).dot(c.normal);
    });
}

std::unique_ptr<Sweeps> sweeps_of(ContactProblem& problem, const Island& island,
                                  std::span<const Held> held)
{
    if (problem.optimised) return optimised_sweeps(problem, island, held);
    if (problem.method == ContactMethod::simultaneous) return simultaneous_sweeps(problem, held);
    return collision_law_sweeps(problem, held);
}

// How many sweeps, and when they may end.
struct Limits {
    int most = 0;
    double unnoticed = 0; // a change that is not seen [m/s]
};

// How far the sweeps were from the answer, by what they changed [m/s].
struct Residuals {
    double first = 0, last = 0;
    bool is_done = false; // nothing changes any more
};

// Sweeps until nothing changes. Goes on in the direction of the sweeps before, as long as it pays:
// directions = steps + β directions, impulses += β directions.
Residuals sweep_on(ContactProblem& problem, Sweeps& sweeps, std::size_t count, const Limits& limits)
{
    Residuals residuals;
    double before = 0, smallest = std::numeric_limits<double>::infinity();
    const bool is_large = count > large; // then the sweeps are better spent
    std::vector<Vector3d> steps(count, Vector3d::Zero());
    std::vector<Vector3d> directions; // from the second sweep on
    bool is_wild = false;             // where that made it worse, it is left
    for (int i = 1; i <= limits.most; ++i) {
        const Progress progress = sweeps.sweep(steps);
        ++problem.counters->contact_sweeps;
        residuals.last = progress.change;
        if (i == 1) residuals.first = progress.change;
        residuals.is_done = progress.change <= rounding * progress.total + limits.unnoticed;
        if (i == limits.most) break;
        if (residuals.is_done && problem.skips.early_exit) {
            ++problem.counters->early_exits;
            break;
        }
        is_wild |= progress.change > 2 * smallest;
        smallest = std::min(smallest, progress.change);
        if (is_large) continue;
        const bool slows_down = before > 0 && progress.squared <= before && !is_wild;
        const double beta = slows_down ? progress.squared / before : 0; // 0: starts afresh
        before = progress.squared;
        directions.resize(count, Vector3d::Zero());
        for (std::size_t k = 0; k < count; ++k) {
            const Vector3d more = beta * directions[k];
            directions[k] = steps[k] + more;
            steps[k] = more;
        }
        if (beta > 0) sweeps.add(steps);
    }
    return residuals;
}

// From wherever the sweeps are to these impulses.
void go_to(Sweeps& sweeps, std::vector<Vector3d> impulses)
{
    const std::vector<Vector3d> here = sweeps.impulses();
    for (std::size_t k = 0; k < here.size(); ++k)
        impulses[k] -= here[k];
    sweeps.add(impulses);
}

// Whether bodies have no velocity but about what the weight of this step gave them.
bool is_at_rest(const ContactProblem& problem, double fastest)
{
    return fastest <= 2 * problem.gravity.norm() * problem.time_step;
}

std::vector<Body> bodies_of(const ContactProblem& problem, const Island& island)
{
    std::vector<Body> bodies;
    for (int i : island.bodies)
        bodies.push_back(problem.bodies[i]);
    return bodies;
}

// What the sweeps started from.
std::vector<Vector3d> guesses(const ContactProblem& problem, std::span<const Held> all)
{
    std::vector<Vector3d> impulses;
    for (const Held& held : all)
        impulses.push_back(problem.contacts[held.contact].guess);
    return impulses;
}

void solve(ContactProblem& problem, const Island& island, std::span<const Held> all)
{
    const int count = static_cast<int>(all.size());
    const double speed = fastest(problem, island, all);
    const bool rests = is_at_rest(problem, speed);
    const std::size_t bodies = island.bodies.size();
    const bool is_on_joint = bodies == 1 && island.pairs.size() > 1; // sweeps are slow there
    // of a heap, Newton's matrix would fill up
    const bool may_jump = (rests || is_on_joint) && !is_heap(island);
    const bool is_small = count <= small || (may_jump && bodies <= few_bodies);
    const double seen = is_small ? tiny : may_jump ? fine : rests ? coarse_at_rest : coarse;
    const int times = rests && !may_jump ? times_at_rest : 1;
    const Limits limits{std::clamp(times * work / count, times * fewest_sweeps, most_sweeps),
                        rounding * speed + seen * approach(problem, all)};
    const std::vector<Body> free = may_jump ? bodies_of(problem, island) : std::vector<Body>();
    const std::unique_ptr<Sweeps> sweeps = sweeps_of(problem, island, all);
    const Residuals swept = sweep_on(problem, *sweeps, all.size(), limits);
    if (!swept.is_done && may_jump) {
        // Newton's impulses, from the better end of the sweeps; kept where the sweeps agree.
        ++problem.counters->newton_solves;
        const std::vector<Vector3d> start =
            swept.last <= swept.first ? sweeps->impulses() : guesses(problem, all);
        std::vector<Vector3d> best = start;
        if (newton_impulses(problem, island, free, all, best)) go_to(*sweeps, best);
        const Limits few{last_sweeps, limits.unnoticed};
        const Residuals after = sweep_on(problem, *sweeps, all.size(), few);
        if (after.first > std::min(swept.first, swept.last)) {
            go_to(*sweeps, start);
            sweep_on(problem, *sweeps, all.size(), few);
        }
    }
    sweeps->finish();
}

} // namespace

Joined<Held> held_contacts(const ContactProblem& problem, const Island& island)
{
    const auto held_of = [&](std::span<const ContactPair> pairs) {
        Joined<Held> held;
        held.reserve(contacts_of(pairs));
        for (const ContactPair& pair : pairs)
            for (int i = pair.first; i < pair.last; ++i) {
                const SolvedContact& c = problem.contacts[i];
                // not a K of anything that moves
                if (!(c.normal_K > 0) || !(c.tangential_K > 0)) continue;
                const double target =
                    c.gap > 0 ? -c.gap / problem.time_step : healing_speed(problem, c);
                held.push_back({i, target, c.normal_K, c.tangential_K});
            }
        return held;
    };
    constexpr std::size_t worth_sharing = 256; // pairs
    const std::span<const ContactPair> pairs = island.pairs;
    return join(*problem.team, pairs.size(), worth_sharing,
                [&](std::size_t first, std::size_t last) {
                    return held_of(pairs.subspan(first, last - first));
                });
}

namespace {

void hold(ContactProblem& problem, const Island& island, std::span<const Held> all)
{
    switch (problem.method) {
    case ContactMethod::one_at_a_time:
        return resolve_one_at_a_time(problem, all, false);
    case ContactMethod::shock_propagation:
        return resolve_one_at_a_time(problem, all, true);
    case ContactMethod::built_in:
    case ContactMethod::simultaneous:
        break;
    }
    const bool is_warm = std::any_of(all.begin(), all.end(), [&](const Held& h) {
        return !problem.contacts[h.contact].guess.isZero(0);
    });
    if (!is_warm) guess_loads(problem, island, all);
    solve(problem, island, all);
}

// Kinetic energy of an island, and what of it is not the motion of all together [J].
struct Energy {
    double all = 0, inner = 0;
};

Energy energy_of(const ContactProblem& problem, const Island& island)
{
    double energy = 0, M = 0;
    Vector3d P(0, 0, 0);
    for (int i : island.bodies) {
        const Body& b = problem.bodies[i];
        const double m = 1 / b.inverse_mass;
        energy += (m * b.velocity.squaredNorm() + b.angular_velocity.dot(b.angular_momentum)) / 2;
        P += m * b.velocity;
        M += m;
    }
    return {energy, energy - P.squaredNorm() / (2 * M)};
}

} // namespace

void process_contact(ContactProblem& problem, const Island& island)
{
    Joined<Held> all = held_contacts(problem, island);
    if (all.empty()) return;
    const bool heals =
        std::any_of(all.begin(), all.end(), [](const Held& h) { return h.target > 0; });
    if (!heals) return hold(problem, island, all);

    // Healing by a speed takes its energy from what the contacts take away, or else waits; only bodies
    // that hardly move against each other get it for nothing.
    const std::vector<Body> bodies = bodies_of(problem, island);
    const Energy before = energy_of(problem, island);
    hold(problem, island, all);
    const double gain = energy_of(problem, island).all - before.all;
    if (gain <= rounding * before.all || gain > before.inner) return;
    for (std::size_t k = 0; k < bodies.size(); ++k)
        problem.bodies[island.bodies[k]] = bodies[k];
    for (Held& held : all) {
        held.target = std::min(held.target, 0.0);
        problem.contacts[held.contact].holding.setZero();
    }
    hold(problem, island, all);
}

} // namespace rigor
