// SPDX-License-Identifier: MIT
#include "formulas/rotation.hpp"
#include "rigid/collisions.hpp"
#include "rigid/contact_problem.hpp"
#include "rigid/contact_stage.hpp"
#include "rigid/flight.hpp"
#include "rigid/forces.hpp"
#include "rigid/healing.hpp"
#include "rigid/neighbourhood.hpp"
#include "rigid/non_finite.hpp"
#include "rigid/warm_start.hpp"
#include "rigid/world.hpp"

#include <algorithm>

namespace rigor {

namespace {

// Which stages gave a body an impulse.
struct Impulses {
    std::vector<bool> bounced, held;
};

Impulses impulses_of(const ContactProblem& problem)
{
    const std::size_t n = problem.bodies.size();
    Impulses impulses{std::vector<bool>(n, false), std::vector<bool>(n, false)};
    for (const SolvedContact& c : problem.contacts)
        for (int i : {c.body1, c.body2}) {
            if (!c.bounce.isZero(0)) impulses.bounced[i] = true;
            if (!c.holding.isZero(0)) impulses.held[i] = true;
        }
    return impulses;
}

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

void displace(RigidState& state, const Displacement& by)
{
    state.position += by.shift;
    if (!by.turn.isZero(0)) state.orientation = advance_exact(state.orientation, by.turn, 1);
}

// Positions. A body that only bounced flies on from there, with gravity in its integrator; a body
// that is held drifts with the velocity it has.
void move(const World& world, const ContactProblem& problem, const std::vector<bool>& pulled,
          const std::vector<Body>& bounced, const std::vector<Displacement>& displacements,
          std::vector<RigidState>& states, Counters& counters)
{
    const Impulses impulses = impulses_of(problem);
    for (const Island& island : problem.islands)
        for (int i : island.bodies) {
            const bool is_displaced = !displacements.empty() && !displacements[i].shift.isZero(0);
            if (!impulses.bounced[i] && !impulses.held[i]) { // its flight was its motion
                if (is_displaced) displace(states[i], displacements[i]);
                continue;
            }
            --counters.free_flights;
            const bool flies = !impulses.held[i] && !pulled[i];
            const Body& body = flies ? bounced[i] : problem.bodies[i];
            RigidState state = world.bodies[i].state;
            state.velocity = body.velocity;
            state.angular_momentum = body.angular_momentum;
            require_finite(world.bodies[i], state, world.time + problem.time_step);
            states[i] = fly(world, world.bodies[i], state, problem.time_step, counters, !flies);
            if (is_displaced) displace(states[i], displacements[i]);
        }
}

std::vector<ContactRecord> records_of(const ContactProblem& problem)
{
    std::vector<ContactRecord> records;
    for (const SolvedContact& c : problem.contacts) {
        const Vector3d impulse = c.bounce + c.holding;
        if (impulse.isZero(0)) continue;
        records.push_back({c.body1, c.body2, c.point, c.normal, -c.gap, impulse});
    }
    return records;
}

} // namespace

std::vector<ContactRecord> step(World& world, double time_step)
{
    Counters& counters = world.counters;
    const double end = world.time + time_step;
    const std::vector<bool> pulled = pulled_bodies(world, time_step);
    std::vector<RigidState> states = fly_all(world, pulled, time_step, counters);
    for (std::size_t i = 0; i < states.size(); ++i) {
        require_finite(world.bodies[i], states[i], end);
        if (!world.bodies[i].is_static) ++counters.free_flights;
    }

    std::vector<ContactRecord> records;
    std::vector<WarmContact> held;
    if (world.bodies.size() > 1) {
        const Neighbourhood near = neighbourhood(world, states, time_step, counters);
        if (!near.contacts.empty()) {
            ContactProblem problem = contact_problem(world, states, near.margins, near.radii,
                                                     near.contacts, time_step, counters);
            for (const Island& island : problem.islands)
                process_collisions(problem, island);
            const std::vector<Body> bounced = problem.bodies;
            std::vector<Displacement> displacements;
            for (const Island& island : problem.islands) {
                add_forces(problem, island, world, states);
                process_contact(problem, island);
                heal(problem, island, displacements);
            }
            move(world, problem, pulled, bounced, displacements, states, counters);
            held = warm_contacts(world, problem.contacts, time_step);
            records = records_of(problem);
            counters.contacts += records.size();
        }
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
        require_finite(world.bodies[i], states[i], end);
        world.bodies[i].state = states[i];
    }
    world.warm_contacts = std::move(held);
    world.time = end;
    ++counters.steps;
    return records;
}

} // namespace rigor
