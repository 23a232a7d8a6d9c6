// SPDX-License-Identifier: MIT
// Advances a world by one time step in the order of Guendelman, Bridson and Fedkiw (2003):
// collisions, velocities, contact, positions. Free flight and the search for contacts come first.
// Bodies that springs pull fly again if they bounce, with their velocities after the collisions,
// and if contacts hold them, with the forces of the contacts. An island whose contacts move along a
// curve, or whose slip turns, is solved again with the contacts in the middle of the step. After
// the positions, single bounces are computed at their exact times. Then the steps of some islands
// are repeated in two parts, such as those with too much new overlap, or with an impact that
// decides what follows (substeps/adaptive_substeps.hpp lists the cases). The step of the whole
// world is repeated in two halves if a body may have penetrated another one where the search for
// contacts did not look, or if forces are too fast for friction. If few bodies move, the first part
// ends after their first bounce instead. Last, islands at rest fall asleep.
#include "rigid/step/step.hpp"

#include "rigid/bodies/non_finite.hpp"
#include "rigid/contact/collisions.hpp"
#include "rigid/contact/driven_bodies.hpp"
#include "rigid/contact/make_problem.hpp"
#include "rigid/contact/position_correction.hpp"
#include "rigid/contact/resting_contact.hpp"
#include "rigid/motion/forces.hpp"
#include "rigid/motion/free_flight.hpp"
#include "rigid/step/bounced_flight.hpp"
#include "rigid/step/impact.hpp"
#include "rigid/step/mean_velocity.hpp"
#include "rigid/step/missed_contacts.hpp"
#include "rigid/step/position_update.hpp"
#include "rigid/step/single_body.hpp"
#include "rigid/step/sleep.hpp"
#include "rigid/step/step_result.hpp"
#include "rigid/step/substeps/adaptive_substeps.hpp"
#include "rigid/step/substeps/divisions.hpp"
#include "rigid/step/supported_flight.hpp"
#include "rigid/step/velocity_update.hpp"

namespace rigor {

namespace {

std::vector<RigidState> free_flight(World& world, const std::vector<bool>& pulled, double time_step,
                                    ThreadPool& pool)
{
    std::vector<RigidState> flown = fly_all(world, pulled, time_step, pool);
    for (std::size_t i = 0; i < flown.size(); ++i) {
        require_finite(world.bodies[i], flown[i], world.time + time_step);
        if (!world.bodies[i].is_still() && !world.bodies[i].is_static)
            ++world.counters.free_flights;
    }
    return flown;
}

// The sum of two lists of displacements, each of which may be empty.
std::vector<Displacement> sum(std::vector<Displacement> a, const std::vector<Displacement>& b)
{
    if (a.empty()) return b;
    for (std::size_t i = 0; i < b.size(); ++i) {
        a[i].shift += b[i].shift;
        a[i].turn += b[i].turn;
    }
    return a;
}

// A step, or a part of a step that was divided.
// @param divisions  those on the way to this part, none for the whole step
std::vector<ContactRecord> step_divided(World& world, double time_step, const Divisions& divisions);

// The step of the whole world in two parts. A contact is listed once for each part in which it got
// an impulse.
// @param divisions  those on the way to the parts
std::vector<ContactRecord> step_in_parts(World& world, double first_part, double second_part,
                                         const Divisions& divisions)
{
    std::vector<ContactRecord> records = step_divided(world, first_part, divisions);
    const std::vector<ContactRecord> second = step_divided(world, second_part, divisions);
    records.insert(records.end(), second.begin(), second.end());
    --world.counters.steps; // the two parts count as one step
    return records;
}

std::vector<ContactRecord> step_in_halves(World& world, double time_step,
                                          const Divisions& divisions)
{
    return step_in_parts(world, time_step / 2, time_step / 2, divisions.with(true));
}

// The results of free flight and of the search for contacts.
struct Flight {
    std::vector<bool> pulled;      // for each body, whether a spring, a force or drag acts on it
    std::vector<RigidState> flown; // the states after free flight
    ContactCandidates candidates;
};

// Free flight, and the search for contacts that may close in this step. A sleeping body that
// another body may touch wakes up and then moves too. So flight and search are repeated until no
// further body wakes.
// @param has_force  for each body, whether springs or applied forces pull on it
Flight fly_and_find_contacts(World& world, const std::vector<bool>& has_force, double time_step,
                             ThreadPool& pool)
{
    const Counters before = world.counters;
    for (;;) {
        Flight flight;
        flight.pulled = with_dragged_bodies(has_force, world);
        flight.flown = free_flight(world, flight.pulled, time_step, pool);
        if (world.bodies.size() < 2) return flight;
        flight.candidates = contact_candidates(world, flight.flown, time_step, pool);
        if (flight.candidates.disturbed.empty()) return flight;
        wake(world, flight.candidates.disturbed);
        world.counters = before; // only the last repetition counts
    }
}

std::vector<ContactRecord> step_divided(World& world, double time_step, const Divisions& divisions)
{
    // Only the reference's formulas are known to be thread-safe. With any other implementation, the
    // step runs on one thread.
    ThreadPool alone;
    ThreadPool& pool = world.settings.formulas_are_reference ? world.pool : alone;
    const std::vector<bool> has_force = pulled_bodies(world, time_step);
    const Counters before = world.counters;
    wake_pulled(world, has_force);

    auto [pulled, flown, candidates] = fly_and_find_contacts(world, has_force, time_step, pool);
    if (candidates.contacts.empty())
        return finish_step(world, time_step, {std::move(flown), {}, {}});

    ContactProblem problem = make_problem(world, flown, candidates, time_step, pool);
    enter_moving_frames(problem);
    process_collisions(problem);
    std::vector<Body> before_forces = problem.bodies;
    BouncedFlight bounced(world, problem, pulled);
    const std::vector<RigidState>& forced_flight = bounced.is_empty() ? flown : bounced.flown();
    for (const Island& island : problem.islands) {
        apply_forces(world, island, before_forces, forced_flight, problem);
        process_contact(problem, island, before_forces);
    }
    if (may_be_halved(world, divisions) && is_too_long_for_friction(world, problem, pulled)) {
        bounced.restore();
        world.counters = before; // only the halves count
        return step_in_halves(world, time_step, divisions);
    }
    const std::optional<SupportedFlight> supported =
        fly_supported(world, problem, before_forces, pulled, forced_flight);
    const std::vector<char> by_mean =
        solve_again_at_midpoint(world, before_forces, supported ? supported->forced : forced_flight,
                                candidates.poses, problem);
    std::vector<Displacement> displacements = position_corrections(problem);
    if (supported) displacements = sum(std::move(displacements), supported->bends);
    leave_unheld_frames(problem, before_forces);

    StepResult result{supported ? supported->flown : forced_flight, {}, {}};
    update_positions(world, problem, pulled, before_forces, by_mean, displacements,
                     bounced.bodies(), result.states);
    bounced.restore();
    leave_moving_frames(problem, before_forces);
    bounce_at_impacts(world, problem, pulled, displacements, result.states);
    const Refinement refined = refine_by_substeps(world, problem, before_forces, pulled, candidates,
                                                  result.states, divisions, step_divided);
    if (may_be_halved(world, divisions) &&
        has_missed_contact(world, problem, candidates, flown, result.states)) {
        const double time = after_first_bounce(world, problem, divisions);
        world.counters = before; // only the parts count
        return time > 0 ? step_in_parts(world, time, time_step - time, divisions.with(false))
                        : step_in_halves(world, time_step, divisions);
    }
    collect_contacts(world, problem, candidates, refined, result);
    fall_asleep(world, problem, candidates.radii, has_force, result);
    return finish_step(world, time_step, std::move(result));
}

} // namespace

std::vector<ContactRecord> step(World& world, double time_step)
{
    if (is_single_body(world)) return step_single_body(world, time_step);
    return step_divided(world, time_step, {});
}

} // namespace rigor
