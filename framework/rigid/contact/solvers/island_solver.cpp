// SPDX-License-Identifier: MIT
// The solver of an island: accelerated projected Gauss–Seidel sweeps (Silcowitz-Hansen, Niebe and
// Erleben 2010), and Newton's method where the sweeps do not converge. First the code derives a
// tolerance from the speeds and the size of the island, then it sweeps. Where forces press bodies
// together and no impulses are known yet, Newton's method comes first. If the sweeps have not
// converged, Newton's method continues in the cases that the header lists, and a few more sweeps
// check its result. Results that are far from the law of contact are dropped.
#include "rigid/contact/solvers/island_solver.hpp"

#include "rigid/contact/solvers/collision_law_sweeps.hpp"
#include "rigid/contact/solvers/far_from_law.hpp"
#include "rigid/contact/solvers/newton_contact.hpp"
#include "rigid/contact/solvers/optimised_sweeps.hpp"
#include "rigid/contact/solvers/run_sweeps.hpp"
#include "rigid/contact/solvers/shared_loads.hpp"
#include "rigid/contact/solvers/simultaneous_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

// Islands with at most this many contacts have the tolerance `to_rounding`, since their sweeps take
// little time. Islands with at most `few_bodies` bodies have this tolerance too if Newton's method
// may follow the sweeps.
constexpr int few_contacts = 16;

// The sweeps of an island end after a limited amount of work, and the next steps correct the error
// that remains. A pile at rest gets more work; otherwise the remaining error would let the pile
// creep, and it would never fall asleep. The numbers were chosen by trial; `bench pile` shows the
// run time and the overlap that they cause.
constexpr int most_visits = 4000; // contacts visited in all sweeps together
constexpr int times_at_rest = 3;  // a pile at rest gets this many times the work
constexpr int fewest_sweeps = 5, most_sweeps = 50;
constexpr int last_sweeps = 20; // most sweeps after Newton's method, which check its result
// The sweeps where no motion obeys the law. With each sweep the impulses grow there, and with them
// the speed by which a body slips out sideways, because its normals are off by a little. Chosen by
// trial, with the meshes between plates in tests/classics.
constexpr int sweeps_in_jams = 5;

// The sweeps end when they change velocities by less than a fraction of the fastest approach speed.
// `plan_for` chooses one of the following fractions. Larger values save sweeps, but let piles
// creep. The first value is a few hundred times the rounding error of a double; the other values
// were chosen by trial, and `bench pile` shows their effect.
constexpr double to_rounding = 1e-13, for_newton = 1e-8, for_piles_at_rest = 1e-4,
                 for_moving_piles = 1e-3;
// The sweeps of a stack have ended far from the solution if two conditions hold. The heaviest body
// has more than `large_ratio` times the mass of the lightest one, and further sweeps would still
// change a velocity by more than the share `far_off` of the fastest approach. Newton's method then
// continues. Both values were chosen by trial; tests/classics shows their effect where heavy bodies
// fall on light ones.
constexpr double large_ratio = 5, far_off = 1e-3;
constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();

// The largest value(contact) of the active contacts, or 0 if all values are negative.
template <class Value>
double largest(const ContactProblem& problem, std::span<const int> active, const Value& value)
{
    const auto largest_of = [&](std::size_t first, std::size_t last) {
        double found = 0;
        for (std::size_t k = first; k < last; ++k)
            found = std::max(found, value(problem.contacts[active[k]]));
        return found;
    };
    constexpr std::size_t grain_size = 512; // a thread takes at least this many contacts at a time
    if (problem.pool->range_count(active.size(), grain_size) < 2)
        return largest_of(0, active.size());
    const std::vector<double> found =
        problem.pool->collect_ranges(active.size(), grain_size, largest_of);
    return *std::max_element(found.begin(), found.end());
}

// The highest speed |V| + |ω| r of a body at a contact (r: length of the lever arm), relative to
// the motion of `ground` [m/s]. Changes of velocities below the rounding error of this speed are
// noise.
// @param ground  if this body is at rest, the result is the speed in world space
double fastest(const ContactProblem& problem, const Island& island, std::span<const int> active,
               const Body& ground)
{
    std::vector<std::pair<double, double>> speeds(problem.bodies.size()); // |V|, |ω| of each body
    for (int i : island.bodies) {
        const Body& body = problem.bodies[i];
        const Vector3d carried =
            ground.velocity + ground.angular_velocity.cross(body.position - ground.position);
        speeds[i] = {(body.velocity - carried).norm(),
                     (body.angular_velocity - ground.angular_velocity).norm()};
    }
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

// The largest amount by which v·n of a contact is below its target speed [m/s]. The impulses have
// to remove it.
double fastest_approach(const ContactProblem& problem, std::span<const int> active)
{
    return largest(problem, active, [&](const ContactConstraint& c) {
        return c.target_speed - problem.velocity_at(c, c.point).dot(c.normal);
    });
}

// The largest speed at which the forces of this step push two bodies together at a contact [m/s].
double fastest_push(const ContactProblem& problem, std::span<const int> active)
{
    return largest(problem, active, [](const ContactConstraint& c) { return -c.force_speed; });
}

// Whether forces other than gravity push bodies of the island together.
bool is_pressed(const ContactProblem& problem, std::span<const int> active)
{
    constexpr double noticeable = 0.01; // relative to gravity; gyroscopic terms cause less
    const Vector3d fall = problem.time_step * problem.settings.gravity;
    return largest(problem, active, [&](const ContactConstraint& c) {
               const int falling =
                   !problem.bodies[c.body1].is_static() - !problem.bodies[c.body2].is_static();
               return falling * fall.dot(c.normal) - c.force_speed;
           }) > noticeable * fall.norm();
}

// The mass of the heaviest body of the island, divided by that of the lightest.
double mass_ratio(const ContactProblem& problem, const Island& island)
{
    double least = std::numeric_limits<double>::infinity(), most = 0; // inverse masses
    for (int i : island.bodies) {
        least = std::min(least, problem.bodies[i].inverse_mass);
        most = std::max(most, problem.bodies[i].inverse_mass);
    }
    return most / least;
}

// The sweeps of the island. They use the engine's faster form of the reference's formulas, if it
// may be used (`Settings::uses_optimised_formulas`); otherwise they call the formula of the contact
// method.
std::unique_ptr<Sweeps> sweeps_of(ContactProblem& problem, const Island& island,
                                  std::span<const int> active)
{
    if (problem.optimised) return optimised_sweeps(problem, island, active);
    if (problem.settings.contact_method == ContactMethod::simultaneous)
        return simultaneous_sweeps(problem, active);
    return collision_law_sweeps(problem, active);
}

// Whether the highest speed is at most `speed_at_rest` times `push`, the speed that the forces give
// a body in this step.
bool is_at_rest(double fastest, double push)
{
    // The forces of this step have already been applied, so gravity has given a body at rest the
    // speed |g| h. The factor 2 allows for errors of earlier steps.
    constexpr double speed_at_rest = 2;
    return fastest <= speed_at_rest * push;
}

// Whether the island is at rest relative to a static or driven body that it touches, such as the
// ground, a lift or a belt. An island that touches no static or driven body is in free flight, and
// never counts as at rest.
// @param speed  the highest speed in world space, which is also the speed relative to a ground at
//               rest
// @param push   see `is_at_rest`
bool rests(const ContactProblem& problem, const Island& island, std::span<const int> active,
           const std::vector<Body>& grounds, double speed, double push)
{
    const bool is_free =
        std::none_of(island.pairs.begin(), island.pairs.end(), [&](const ContactPair& pair) {
            const ContactConstraint& c = problem.contacts[pair.first];
            return problem.bodies[c.body1].is_static() || problem.bodies[c.body2].is_static();
        });
    return !is_free && std::any_of(grounds.begin(), grounds.end(), [&](const Body& ground) {
        const bool moves = !ground.velocity.isZero(0) || !ground.angular_velocity.isZero(0);
        return is_at_rest(moves ? fastest(problem, island, active, ground) : speed, push);
    });
}

std::vector<Vector3d> initial_impulses(const ContactProblem& problem, std::span<const int> active)
{
    std::vector<Vector3d> impulses;
    for (int i : active)
        impulses.push_back(problem.contacts[i].initial_impulse);
    return impulses;
}

// Whether the impulses would add kinetic energy to the bodies of the island, measured relative to
// the first of its grounds (`ContactProblem::grounds_of`).
// @param bodies  the bodies before these impulses, in the order of the island
bool adds_energy(const ContactProblem& problem, const Island& island, std::span<const int> active,
                 std::vector<Body> bodies, const std::vector<Vector3d>& impulses)
{
    constexpr double least_gain = 1e-9; // relative to the energy; a smaller gain is rounding
    std::vector<int> places(problem.bodies.size(), -1);
    for (std::size_t i = 0; i < island.bodies.size(); ++i)
        places[island.bodies[i]] = static_cast<int>(i);
    const Vector3d V = problem.grounds_of(island).front().velocity;
    const double before = kinetic_energy_of(bodies, V);
    for (std::size_t k = 0; k < active.size(); ++k) {
        const ContactConstraint& c = problem.contacts[active[k]];
        if (const int i = places[c.body1]; i >= 0) problem.push(bodies[i], c.point, impulses[k]);
        if (const int i = places[c.body2]; i >= 0) problem.push(bodies[i], c.point, -impulses[k]);
    }
    return kinetic_energy_of(bodies, V) > (1 + least_gain) * before;
}

// The start of Newton's method, and the condition under which its result is accepted.
struct NewtonStart {
    const std::vector<Body>& free; // the island's bodies before the contact stage
    const std::vector<Vector3d>& impulses;
    double allowed = 0;  // largest change by the first sweep after Newton's method [m/s]
    double approach = 0; // see `is_far_from_law` [m/s]
};

// Continues by Newton's method and checks the result by a few sweeps. The result is accepted if the
// first of these sweeps changes velocities by at most `start.allowed`, and if the result is not far
// from the law (`is_far_from_law`).
// @return whether the result is accepted
bool solve_by_newton(ContactProblem& problem, const Island& island, std::span<const int> active,
                     const NewtonStart& start, const SweepLimits& check, Sweeps& sweeps)
{
    ++problem.counters->newton_solves;
    std::vector<Vector3d> impulses = start.impulses;
    if (!newton_impulses(problem, island, start.free, active, impulses)) return false;
    set_impulses(sweeps, impulses);
    return run_sweeps(problem, sweeps, active.size(), check).first <= start.allowed &&
           !is_far_from_law(problem, island, active, sweeps.impulses(), start.approach);
}

// The limits of the sweeps over an island, and whether Newton's method may follow them.
struct SolvePlan {
    double approach = 0; // result of `fastest_approach` [m/s]
    SweepLimits limits;
    // Whether Newton's method follows sweeps that do not converge, whatever `is_far_off` returns.
    bool may_use_newton = false;
    // Whether the island is not a pile. Newton's method is too slow for piles, whose sparse matrix
    // gets too much fill-in when it is factorized.
    bool is_stack = false;
    // Whether the island is at rest and other forces than gravity push its bodies together, as
    // between the jaws of a vice.
    bool is_pressed = false;
    std::vector<Body> free; // the bodies of a stack before the contact stage; empty for a pile
};

SolvePlan plan_for(const ContactProblem& problem, const Island& island, std::span<const int> active)
{
    const int count = static_cast<int>(active.size());
    const double speed = fastest(problem, island, active, Body());
    const double weight = problem.settings.gravity.norm() * problem.time_step; // [m/s]
    const double push = fastest_push(problem, active);
    const bool is_resting =
        rests(problem, island, active, problem.grounds_of(island), speed, std::max(weight, push));
    const std::size_t bodies = island.bodies.size();
    // A single body on several static or driven bodies, as on the joint between two tiles. There
    // sweeps converge slowly.
    const bool is_on_joint = bodies == 1 && island.pairs.size() > 1;
    const bool is_stack = !is_pile(island);
    const bool may_use_newton = (is_resting || is_on_joint) && is_stack;
    const double approach = fastest_approach(problem, active);
    const bool is_small = count <= few_contacts || (may_use_newton && bodies <= few_bodies);
    const double tolerance = is_small         ? to_rounding
                             : may_use_newton ? for_newton
                             : is_resting     ? for_piles_at_rest
                                              : for_moving_piles;
    const int times = is_resting && !may_use_newton ? times_at_rest : 1;
    const int sweeps = std::clamp(times * most_visits / count, times * fewest_sweeps, most_sweeps);
    return {approach,
            {sweeps, rounding * speed + tolerance * approach},
            may_use_newton,
            is_stack,
            is_resting && is_pressed(problem, active),
            is_stack ? problem.bodies_of(island) : std::vector<Body>()};
}

// Whether the sweeps have ended far from the solution in a stack of bodies with very different
// masses, see `large_ratio`.
bool is_far_off(const ContactProblem& problem, const Island& island, const SolvePlan& plan,
                const Residuals& swept)
{
    return plan.is_stack && mass_ratio(problem, island) > large_ratio &&
           swept.missing() > far_off * plan.approach;
}

// Continues after sweeps that have not converged; `swept` are their residuals. The function makes
// these attempts in this order and returns after the first that succeeds:
// 1. Newton's method from the impulses of the sweeps, or from the initial impulses if the last
//    sweep changed velocities more than the first.
// 2. If `is_far_off` is true, Newton's method from zero impulses, since both starts of attempt 1
//    may be far from the solution.
// 3. Up to `last_sweeps` sweeps from the start of attempt 1. If `is_far_off`, their result is kept
//    only for one or two bodies whose energy has not grown.
// 4. Sweeps from zero impulses, as many as `plan.limits` allows. Sweeps that start from zero
//    impulses dissipate energy.
// @return whether a result of Newton's method was accepted
bool continue_by_newton(ContactProblem& problem, const Island& island, std::span<const int> active,
                        const SolvePlan& plan, const Residuals& swept, Sweeps& sweeps)
{
    const bool may_be_lost = is_far_off(problem, island, plan, swept);
    const std::vector<Vector3d> start =
        swept.last <= swept.first ? sweeps.impulses() : initial_impulses(problem, active);
    const std::vector<Vector3d> none(active.size(), Vector3d::Zero());
    const double allowed = std::min(swept.first, swept.last);
    const SweepLimits check{last_sweeps, plan.limits.negligible_change};
    const auto newton_from = [&](const std::vector<Vector3d>& impulses) {
        return solve_by_newton(problem, island, active,
                               {plan.free, impulses, allowed, plan.approach}, check, sweeps);
    };
    if (newton_from(start) || (may_be_lost && newton_from(none))) return true;

    set_impulses(sweeps, start);
    run_sweeps(problem, sweeps, active.size(), check);
    if (!may_be_lost) return false;
    // With more than two bodies, it is not enough that the total energy has not increased: one body
    // may still be too fast.
    const bool is_pair = island.bodies.size() <= 2;
    if (is_pair && !adds_energy(problem, island, active, plan.free, sweeps.impulses()))
        return false;
    set_impulses(sweeps, none);
    run_sweeps(problem, sweeps, active.size(), plan.limits);
    return false;
}

bool starts_from_zero(const ContactProblem& problem, std::span<const int> active)
{
    return std::all_of(active.begin(), active.end(),
                       [&](int i) { return problem.contacts[i].initial_impulse.isZero(0); });
}

// Starts with the impulses that Newton's method finds from zero. Its first round is that of equally
// stiff springs at all contacts, so each face presses evenly. Where the law of contact leaves the
// loads open, sweeps may put the load of a face on the corner that they visit first. Then friction
// would turn the body round this corner, and it would slip although the face as a whole holds it.
void start_by_newton(ContactProblem& problem, const Island& island, std::span<const int> active,
                     const SolvePlan& plan, Sweeps& sweeps)
{
    std::vector<Vector3d> impulses(active.size(), Vector3d::Zero());
    ++problem.counters->newton_solves;
    if (!newton_impulses(problem, island, plan.free, active, impulses)) return;
    set_impulses(sweeps, impulses);
    if (is_far_from_law(problem, island, active, impulses, plan.approach))
        set_impulses(sweeps, std::vector<Vector3d>(active.size(), Vector3d::Zero()));
}

// Continues after sweeps that have not converged; `swept` are their residuals. If their result is
// far from the law (`is_far_from_law`), so were the initial impulses: they are dropped, and the
// sweeps start from zero impulses. This happens in jams, where the impulses of the last step were
// no solution, and after a short part of a step that stopped a hit, since the impulse of a hit does
// not grow with the length of the step, as that of a load does. Then Newton's method may continue.
// If the result is still far from the law, few sweeps from zero impulses replace it.
void continue_sweeps(ContactProblem& problem, const Island& island, std::span<const int> active,
                     const SolvePlan& plan, Residuals swept, Sweeps& sweeps)
{
    const auto is_far = [&] {
        return is_far_from_law(problem, island, active, sweeps.impulses(), plan.approach);
    };
    const auto sweep_from_zero = [&](const SweepLimits& limits) {
        set_impulses(sweeps, std::vector<Vector3d>(active.size(), Vector3d::Zero()));
        return run_sweeps(problem, sweeps, active.size(), limits);
    };
    bool may_be_far = is_far();
    if (may_be_far && !starts_from_zero(problem, active)) {
        for (int i : active)
            problem.contacts[i].initial_impulse.setZero();
        swept = sweep_from_zero(plan.limits);
        if (swept.has_converged) return;
    }
    if (plan.may_use_newton || is_far_off(problem, island, plan, swept))
        may_be_far |= !continue_by_newton(problem, island, active, plan, swept, sweeps);
    if (may_be_far && is_far()) sweep_from_zero({sweeps_in_jams, plan.limits.negligible_change});
}

} // namespace

void solve_island(ContactProblem& problem, const Island& island, std::span<const int> active)
{
    const SolvePlan plan = plan_for(problem, island, active);
    const std::unique_ptr<Sweeps> sweeps =
        with_shared_loads(problem, island, active, sweeps_of(problem, island, active));
    if (plan.is_pressed && plan.is_stack && starts_from_zero(problem, active))
        start_by_newton(problem, island, active, plan, *sweeps);
    const Residuals swept = run_sweeps(problem, *sweeps, active.size(), plan.limits);
    if (!swept.has_converged) continue_sweeps(problem, island, active, plan, swept, *sweeps);
    sweeps->finish();
}

} // namespace rigor
