// SPDX-License-Identifier: MIT
// The position update. Each body that got an impulse flies once more, by the integrator of free
// flight, with its velocity after the contact stage. In some islands (`by_mean`), it flies with the
// mean of this velocity and that after the collision stage. If the body only bounced and no spring,
// force or drag pulls it, it flies with its velocity after the collision stage, and this flight
// adds gravity. The displacements of the position correction are added last. Velocities in a moving
// frame (contact/driven_bodies) become velocities in the world.
#include "rigid/step/position_update.hpp"

#include "formulas/rotation.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/motion/free_flight.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// `has_bounced`: whether the collision stage gave a body an impulse; `has_contact_impulse`: whether
// the contact stage did (`ContactProblem::holds`).
struct Impulses {
    bool has_bounced = false, has_contact_impulse = false;
};

std::vector<Impulses> impulses_of(const ContactProblem& problem)
{
    std::vector<Impulses> impulses(problem.bodies.size());
    for (const ContactConstraint& c : problem.contacts) {
        Impulses &first = impulses[c.body1], &second = impulses[c.body2];
        if (!c.collision_impulse.isZero(0)) first.has_bounced = second.has_bounced = true;
        if (first.has_contact_impulse && second.has_contact_impulse) continue;
        if (problem.holds(c)) first.has_contact_impulse = second.has_contact_impulse = true;
    }
    return impulses;
}

void displace(RigidState& state, const Displacement& by)
{
    state.position += by.shift;
    if (!by.turn.isZero(0)) state.orientation = advance_exact(state.orientation, by.turn, 1);
}

} // namespace

void update_positions(World& world, const ContactProblem& problem, const std::vector<bool>& pulled,
                      const std::vector<Body>& before_forces, const std::vector<char>& by_mean,
                      const std::vector<Displacement>& displacements,
                      const std::vector<bool>& flown_again, std::vector<RigidState>& states)
{
    Counters& counters = world.counters;
    const std::vector<Impulses> impulses = impulses_of(problem);
    const auto is_flown_again = [&](int i) { return !flown_again.empty() && flown_again[i]; };
    const auto move = [&](int i, bool by_mean_velocity, const MovingFrame& frame,
                          Counters& counted) {
        const bool is_displaced = !displacements.empty() && !displacements[i].is_zero();
        const auto [has_bounced, has_contact_impulse] = impulses[i];
        if (!has_contact_impulse && (!has_bounced || is_flown_again(i))) { // keep the flown state
            if (is_displaced) displace(states[i], displacements[i]);
            ++counted.free_flights;
            return;
        }
        const bool flies = !has_contact_impulse && !pulled[i];
        const Body& body = flies ? before_forces[i] : problem.bodies[i];
        RigidState state = world.bodies[i].state;
        state.velocity = body.velocity;
        if (flies) state.velocity -= frame.mean_minus_first;
        state.angular_momentum = body.angular_momentum;
        require_finite(world.bodies[i], state, world.time + problem.time_step);
        const bool is_mean = by_mean_velocity && !flies;
        if (is_mean) {
            const Body& first = before_forces[i];
            state.velocity = (first.velocity + body.velocity) / 2;
            state.angular_momentum = (first.angular_momentum + body.angular_momentum) / 2;
        }
        states[i] = fly(world.settings, world.bodies[i], state, problem.time_step, counted,
                        flies ? Gravity::acts : Gravity::left_out);
        if (is_mean) {
            states[i].velocity = body.velocity;
            states[i].angular_momentum = body.angular_momentum;
        }
        if (!flies) states[i].velocity += frame.last_minus_mean;
        if (is_displaced) displace(states[i], displacements[i]);
    };
    for (std::size_t k = 0; k < problem.islands.size(); ++k) {
        const Island& island = problem.islands[k];
        const bool by_mean_velocity = by_mean[k];
        fly_in_parallel(*problem.pool, island.bodies.size(), counters,
                        [&](std::size_t first, std::size_t last, Counters& counted) {
                            for (std::size_t at = first; at < last; ++at)
                                move(island.bodies[at], by_mean_velocity, island.frame, counted);
                        });
        // The stage of free flight counted a flight for every body of the island. Only the
        // flights of bodies without an impulse should count, and `move` has counted these flights a
        // second time.
        counters.free_flights -= island.bodies.size();
    }
}

} // namespace rigor
