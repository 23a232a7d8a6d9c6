// SPDX-License-Identifier: MIT
// The solver of an island: accelerated projected Gauss–Seidel sweeps (Silcowitz-Hansen, Niebe and
// Erleben 2010), and Newton's method where the sweeps do not converge. First it derives the
// tolerance from the island's size and speed, then it sweeps. If bodies at rest have not converged,
// Newton's method continues, and a few more sweeps check its result.
#include "rigid/contact/solvers/island_solver.hpp"

#include "rigid/contact/solvers/collision_law_sweeps.hpp"
#include "rigid/contact/solvers/newton_contact.hpp"
#include "rigid/contact/solvers/optimised_sweeps.hpp"
#include "rigid/contact/solvers/simultaneous_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr int few_contacts = 16; // islands with at most so many contacts converge to rounding
// Islands with at most so many bodies do so too, if Newton's method may help.
constexpr std::size_t few_bodies = 8;
constexpr std::size_t many_contacts = 1000; // sweeps over more contacts are not accelerated

// A larger island stops after a limited amount of work, and the remaining error is corrected in the
// next steps. A heap at rest gets more work, since the remaining error would let it creep and it
// would never fall asleep.
constexpr int most_visits = 4000; // contacts visited in all sweeps together
constexpr int times_at_rest = 3;  // a heap at rest gets this many times the work
constexpr int fewest_sweeps = 5, most_sweeps = 50;
constexpr int last_sweeps = 20; // sweeps after Newton's method

// Changes below these fractions of the fastest approach are negligible.
constexpr double to_rounding = 1e-13, for_newton = 1e-8, for_heaps_at_rest = 1e-4,
                 for_moving_heaps = 1e-3;
constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();

// The largest of value(contact) over the active contacts, at least 0.
template <class Value>
double largest(const ContactProblem& problem, std::span<const int> active, const Value& value)
{
    const auto largest_of = [&](std::size_t first, std::size_t last) {
        double found = 0;
        for (std::size_t k = first; k < last; ++k)
            found = std::max(found, value(problem.contacts[active[k]]));
        return found;
    };
    constexpr std::size_t grain_size = 512; // contacts
    if (problem.pool->range_count(active.size(), grain_size) < 2)
        return largest_of(0, active.size());
    const std::vector<double> found =
        problem.pool->collect_ranges(active.size(), grain_size, largest_of);
    return *std::max_element(found.begin(), found.end());
}

// The highest speed of a body at a contact [m/s]. Velocity differences below its rounding error are
// noise.
double fastest(const ContactProblem& problem, const Island& island, std::span<const int> active)
{
    std::vector<std::pair<double, double>> speeds(problem.bodies.size()); // |V|, |ω|
    for (int i : island.bodies)
        speeds[i] = {problem.bodies[i].velocity.norm(), problem.bodies[i].angular_velocity.norm()};
    return largest(problem, active, [&](const ContactConstraint& c) {
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

// The highest speed of approach at a contact [m/s], which the impulses have to remove.
double fastest_approach(const ContactProblem& problem, std::span<const int> active)
{
    return largest(problem, active, [&](const ContactConstraint& c) {
        return c.target_speed - problem.velocity_at(c, c.point).dot(c.normal);
    });
}

// The kind of sweeps that the world's contact method asks for.
std::unique_ptr<Sweeps> sweeps_of(ContactProblem& problem, const Island& island,
                                  std::span<const int> active)
{
    if (problem.optimised) return optimised_sweeps(problem, island, active);
    if (problem.settings.contact_method == ContactMethod::simultaneous)
        return simultaneous_sweeps(problem, active);
    return collision_law_sweeps(problem, active);
}

// Limits at which a run of sweeps ends.
struct SweepLimits {
    int most_sweeps = 0;
    double negligible_change = 0; // [m/s]
};

// Convergence of a run of sweeps: the largest change in the first and in the last sweep [m/s].
struct Residuals {
    double first = 0, last = 0;
    bool has_converged = false; // whether the last sweep changed nothing that matters
};

// Sweeps until the changes are negligible or the limit is reached. After each sweep the impulses
// also move on in the direction of the previous sweeps, as long as this helps (nonlinear conjugate
// gradients): directions = steps + β directions, impulses += β directions.
Residuals run_sweeps(ContactProblem& problem, Sweeps& sweeps, std::size_t count,
                     const SweepLimits& limits)
{
    Residuals residuals;
    double before = 0, smallest = std::numeric_limits<double>::infinity();
    const bool is_large = count > many_contacts; // plain sweeps then gain more in the same time
    std::vector<Vector3d> steps(count, Vector3d::Zero());
    std::vector<Vector3d> directions; // set from the second sweep on
    bool diverges = false;            // whether the acceleration has made the residual larger
    for (int i = 1; i <= limits.most_sweeps; ++i) {
        const Progress progress = sweeps.sweep(steps);
        ++problem.counters->contact_sweeps;
        residuals.last = progress.change;
        if (i == 1) residuals.first = progress.change;
        residuals.has_converged =
            progress.change <= rounding * progress.total + limits.negligible_change;
        if (i == limits.most_sweeps) break;
        if (residuals.has_converged && problem.settings.skips.early_exit) {
            ++problem.counters->early_exits;
            break;
        }
        diverges |= progress.change > 2 * smallest;
        smallest = std::min(smallest, progress.change);
        if (is_large) continue;
        const bool slows_down = before > 0 && progress.squared <= before && !diverges;
        // β = 0 restarts the directions.
        const double beta = slows_down ? progress.squared / before : 0;
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

// Changes the impulses of the sweeps to the given ones.
void set_impulses(Sweeps& sweeps, std::vector<Vector3d> impulses)
{
    const std::vector<Vector3d> here = sweeps.impulses();
    for (std::size_t k = 0; k < here.size(); ++k)
        impulses[k] -= here[k];
    sweeps.add(impulses);
}

// Whether bodies have little more velocity than gravity has given them in this step.
bool is_at_rest(const ContactProblem& problem, double fastest)
{
    return fastest <= 2 * problem.settings.gravity.norm() * problem.time_step;
}

std::vector<Vector3d> initial_impulses(const ContactProblem& problem, std::span<const int> active)
{
    std::vector<Vector3d> impulses;
    for (int i : active)
        impulses.push_back(problem.contacts[i].initial_impulse);
    return impulses;
}

} // namespace

void solve_island(ContactProblem& problem, const Island& island, std::span<const int> active)
{
    const int count = static_cast<int>(active.size());
    const double speed = fastest(problem, island, active);
    const bool rests = is_at_rest(problem, speed);
    const std::size_t bodies = island.bodies.size();
    const bool is_on_joint = bodies == 1 && island.pairs.size() > 1; // sweeps converge slowly there
    // Not for a heap: the factors of its sparse matrix would have too many entries (fill-in).
    const bool may_use_newton = (rests || is_on_joint) && !is_heap(island);
    const bool is_small = count <= few_contacts || (may_use_newton && bodies <= few_bodies);
    const double tolerance = is_small         ? to_rounding
                             : may_use_newton ? for_newton
                             : rests          ? for_heaps_at_rest
                                              : for_moving_heaps;
    const int times = rests && !may_use_newton ? times_at_rest : 1;
    const SweepLimits limits{
        std::clamp(times * most_visits / count, times * fewest_sweeps, most_sweeps),
        rounding * speed + tolerance * fastest_approach(problem, active)};
    const std::vector<Body> free = may_use_newton ? problem.bodies_of(island) : std::vector<Body>();
    const std::unique_ptr<Sweeps> sweeps = sweeps_of(problem, island, active);
    const Residuals swept = run_sweeps(problem, *sweeps, active.size(), limits);
    if (!swept.has_converged && may_use_newton) {
        // Newton's method starts from the better of two sets of impulses: those after the sweeps or
        // those before them. Its impulses are kept if the next sweeps change them by less than the
        // earlier sweeps changed theirs.
        ++problem.counters->newton_solves;
        const std::vector<Vector3d> start =
            swept.last <= swept.first ? sweeps->impulses() : initial_impulses(problem, active);
        std::vector<Vector3d> best = start;
        if (newton_impulses(problem, island, free, active, best)) set_impulses(*sweeps, best);
        const SweepLimits few{last_sweeps, limits.negligible_change};
        const Residuals after = run_sweeps(problem, *sweeps, active.size(), few);
        if (after.first > std::min(swept.first, swept.last)) {
            set_impulses(*sweeps, start);
            run_sweeps(problem, *sweeps, active.size(), few);
        }
    }
    sweeps->finish();
}

} // namespace rigor
