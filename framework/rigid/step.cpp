// SPDX-License-Identifier: MIT
#include "rigid/collisions.hpp"
#include "rigid/contact_problem.hpp"
#include "rigid/contact_stage.hpp"
#include "rigid/drift.hpp"
#include "rigid/flight.hpp"
#include "rigid/forces.hpp"
#include "rigid/halving.hpp"
#include "rigid/healing.hpp"
#include "rigid/impact.hpp"
#include "rigid/non_finite.hpp"
#include "rigid/sleep.hpp"
#include "rigid/warm_start.hpp"
#include "rigid/world.hpp"

#include <algorithm>

namespace rigor {

namespace {

// Velocities: what the forces did to the momentum of a body in flight, they do to it here.
void add_forces(ContactProblem& problem, const Island& island, const World& world,
                std::span<const RigidState> flown)
{
    for (int i : island.bodies) {
        Body& body = problem.bodies[i];
        const RigidState& start = world.bodies[i].state;
        const Vector3d dL = flown[i].angular_momentum - start.angular_momentum;
        body.velocity += flown[i].velocity - start.velocity;
        body.angular_momentum += dL;
        body.angular_velocity += body.inverse_inertia * dL;
    }
}

std::vector<ContactRecord> records_of(const ContactProblem& problem)
{
    std::vector<ContactRecord> records;
    records.reserve(problem.contacts.size());
    for (const SolvedContact& c : problem.contacts) {
        const Vector3d impulse = c.bounce + c.holding;
        if (impulse.isZero(0)) continue;
        records.push_back({c.body1, c.body2, c.point, c.normal, -c.gap, impulse});
    }
    return records;
}

// The only pair of an island that bounced, if it did nothing else.
const ContactPair* lone_bounce(const ContactProblem& problem, const Island& island)
{
    const ContactPair* lone = nullptr;
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            const SolvedContact& c = problem.contacts[i];
            if (!c.holding.isZero(0)) return nullptr;
            if (c.bounce.isZero(0)) continue;
            if (lone && lone != &pair) return nullptr;
            lone = &pair;
        }
    return lone;
}

// @return the contacts of those bounces; they are no longer among the problem's
std::vector<ContactRecord> bounce_at_impacts(const World& world, ContactProblem& problem,
                                             const std::vector<bool>& pulled,
                                             const std::vector<Displacement>& displacements,
                                             std::vector<RigidState>& states)
{
    std::vector<ContactRecord> records;
    for (const Island& island : problem.islands) {
        const ContactPair* pair = lone_bounce(problem, island);
        if (!pair) continue;
        const SolvedContact& c = problem.contacts[pair->first];
        const auto is_moved_else = [&](int i) {
            return pulled[i] || (!displacements.empty() && !displacements[i].shift.isZero(0));
        };
        if (is_moved_else(c.body1) || is_moved_else(c.body2)) continue;
        const auto found = bounce_at_impact(world, problem, *pair, states);
        if (!found) continue;
        records.insert(records.end(), found->begin(), found->end());
        for (int i = pair->first; i < pair->last; ++i)
            problem.contacts[i].bounce.setZero();
    }
    return records;
}

// What a step starts with: free flight, and what may meet. Sleeping bodies that may be touched wake first,
// and then those that they may touch.
struct Start {
    std::vector<bool> pulled;
    std::vector<RigidState> flown;
    Neighbourhood near;
};

Start start_of_step(World& world, double time_step, Team& team)
{
    Start start;
    start.pulled = pulled_bodies(world, time_step);
    for (std::size_t i = 0; i < start.pulled.size(); ++i)
        if (start.pulled[i] && world.bodies[i].rest.is_asleep()) wake(world, {static_cast<int>(i)});
    const auto fly_freely = [&] {
        start.flown = fly_all(world, start.pulled, time_step, world.counters, team);
        for (std::size_t i = 0; i < start.flown.size(); ++i) {
            require_finite(world.bodies[i], start.flown[i], world.time + time_step);
            if (!world.bodies[i].is_still()) ++world.counters.free_flights;
        }
    };
    if (world.bodies.size() < 2) {
        fly_freely();
        return start;
    }
    for (const Counters before = world.counters;;) {
        fly_freely();
        start.near = neighbourhood(world, start.flown, time_step, world.near, world.counters, team);
        if (start.near.disturbed.empty()) return start;
        wake(world, start.near.disturbed);
        world.counters = before;
    }
}

// Among those of the other islands, in the order of the bodies.
void take_warm(const std::vector<WarmContact>& more, std::vector<WarmContact>& held)
{
    if (more.empty()) return;
    held.insert(held.end(), more.begin(), more.end());
    std::stable_sort(held.begin(), held.end(), [](const WarmContact& a, const WarmContact& b) {
        return std::pair(a.body1, a.body2) < std::pair(b.body1, b.body2);
    });
}

// What a step ends with.
struct End {
    std::vector<RigidState> states;
    std::vector<ContactRecord> records;
    std::vector<WarmContact> held;
};

std::vector<ContactRecord> step_halved(World& world, double time_step, int halvings);

// The stages of contact. @param halvings  of the step that this is a part of
End after_contacts(World& world, double time_step, const Start& start, Team& team, int halvings)
{
    constexpr int most_halvings = 10;
    const auto& [pulled, flown, near] = start;
    Counters& counters = world.counters;
    End end = {flown, {}, {}};
    ContactProblem problem = contact_problem(world, flown, near, time_step, counters, team);
    for (const Island& island : problem.islands)
        process_collisions(problem, island);
    const std::vector<Body> bounced = problem.bodies;
    std::vector<Displacement> displacements;
    for (const Island& island : problem.islands) {
        add_forces(problem, island, world, flown);
        process_contact(problem, island);
        heal(problem, island, displacements);
    }
    move(world, problem, pulled, bounced, displacements, end.states, counters);
    end.records = bounce_at_impacts(world, problem, pulled, displacements, end.states);
    Halving halving(world, pulled, near);
    if (halvings < most_halvings)
        halving.step_in_halves(problem, end.states, [&](World& part, double half) {
            return step_halved(part, half, halvings + 1);
        });
    std::vector<ContactRecord> others;
    constexpr std::size_t worth_sharing = 512; // contacts
    team.share_both(
        problem.contacts.size(), worth_sharing,
        [&, &poses = near.poses] { end.held = warm_contacts(poses, problem.contacts, time_step); },
        [&] { others = records_of(problem); });
    take_warm(halving.warm, end.held);
    if (end.records.empty())
        end.records = std::move(others);
    else
        end.records.insert(end.records.end(), others.begin(), others.end());
    counters.contacts += end.records.size();
    end.records.insert(end.records.end(), halving.records.begin(), halving.records.end());
    counters.islands += problem.islands.size();
    for (std::size_t i = 0; i < end.states.size(); ++i)
        require_finite(world.bodies[i], end.states[i], world.time + time_step);
    fall_asleep(world, problem, near.radii, pulled, end.states, end.records);
    // those of bodies that fell asleep in this step are among those of the sleeping
    std::erase_if(end.records, [&](const ContactRecord& r) {
        return world.bodies[r.body1].rest.is_asleep() || world.bodies[r.body2].rest.is_asleep();
    });
    return end;
}

// @param halvings  of the step that this is a part of
std::vector<ContactRecord> step_halved(World& world, double time_step, int halvings)
{
    Team alone;
    Team& team = world.formulas_are_reference ? world.team : alone;
    Start start = start_of_step(world, time_step, team);
    End end;
    if (start.near.contacts.empty())
        end.states = std::move(start.flown);
    else
        end = after_contacts(world, time_step, start, team, halvings);
    for (std::size_t i = 0; i < end.states.size(); ++i)
        world.bodies[i].state = end.states[i];
    end.records.insert(end.records.end(), world.sleeping_contacts.begin(),
                       world.sleeping_contacts.end());
    world.warm_contacts = std::move(end.held);
    world.time += time_step;
    ++world.counters.steps;
    return std::move(end.records);
}

// The only body of a world meets nothing.
RigidState flight_of_one(World& world, double time_step)
{
    const RigidBody& body = world.bodies[0];
    Counters& counters = world.counters;
    if (body.is_still() || !world.springs.empty() || !world.forces.empty()) {
        Team alone;
        return start_of_step(world, time_step, alone).flown[0];
    }
    const RigidState flown = fly(world, body, body.state, time_step, counters);
    require_finite(body, flown, world.time + time_step);
    ++counters.free_flights;
    return flown;
}

} // namespace

std::vector<ContactRecord> step(World& world, double time_step)
{
    if (world.bodies.size() != 1) return step_halved(world, time_step, 0);
    world.bodies[0].state = flight_of_one(world, time_step);
    world.warm_contacts.clear();
    world.time += time_step;
    ++world.counters.steps;
    return world.sleeping_contacts;
}

} // namespace rigor
