// SPDX-License-Identifier: MIT
#include "rigid/drift.hpp"

#include "formulas/rotation.hpp"
#include "rigid/flight.hpp"
#include "rigid/non_finite.hpp"

#include <cmath>

namespace rigor {

namespace {

// Which stages gave a body an impulse.
struct Impulses {
    bool bounced = false, held = false;
};

std::vector<Impulses> impulses_of(const ContactProblem& problem)
{
    std::vector<Impulses> impulses(problem.bodies.size());
    for (const SolvedContact& c : problem.contacts)
        for (int i : {c.body1, c.body2}) {
            if (!c.bounce.isZero(0)) impulses[i].bounced = true;
            if (!c.holding.isZero(0)) impulses[i].held = true;
        }
    return impulses;
}

void displace(RigidState& state, const Displacement& by)
{
    state.position += by.shift;
    if (!by.turn.isZero(0)) state.orientation = advance_exact(state.orientation, by.turn, 1);
}

// Whether a flight's positions have an order above the first: what is held shall not have less.
bool is_of_higher_order(Integrator integrator)
{
    return integrator == Integrator::runge_kutta || integrator == Integrator::matrix;
}

// Whether contacts hold an island all the step long along the same normals: then they are as strong at its end,
// as on an incline. On a bowl's wall the mean of two velocities would bring in energy.
bool is_held_evenly(const ContactProblem& problem, const Island& island,
                    const std::vector<Body>& before)
{
    constexpr double seen = 1e-9; // of the speed: that a contact opens or closes
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            const SolvedContact& c = problem.contacts[i];
            if (!c.bounce.isZero(0)) return false;
            if (c.holding.isZero(0)) continue;
            for (const std::vector<Body>* bodies : {&before, &problem.bodies}) {
                const double v_n = problem.velocity_between(*bodies, c, c.point).dot(c.normal);
                const double speed =
                    (*bodies)[c.body1].velocity.norm() + (*bodies)[c.body2].velocity.norm();
                if (std::abs(v_n) > seen * speed) return false;
            }
        }
    return true;
}

} // namespace

void move(const World& world, const ContactProblem& problem, const std::vector<bool>& pulled,
          const std::vector<Body>& bounced, const std::vector<Displacement>& displacements,
          std::vector<RigidState>& states, Counters& counters)
{
    const std::vector<Impulses> impulses = impulses_of(problem);
    const auto move_one = [&](int i, bool evenly, Counters& counted) {
        const bool is_displaced = !displacements.empty() && !displacements[i].shift.isZero(0);
        const auto [bounced_off, is_held] = impulses[i];
        if (!bounced_off && !is_held) { // its flight was its motion
            if (is_displaced) displace(states[i], displacements[i]);
            ++counted.free_flights;
            return;
        }
        const bool flies = !is_held && !pulled[i];
        const Body& body = flies ? bounced[i] : problem.bodies[i];
        RigidState state = world.bodies[i].state;
        const Vector3d V = state.velocity, L = state.angular_momentum;
        state.velocity = body.velocity;
        state.angular_momentum = body.angular_momentum;
        require_finite(world.bodies[i], state, world.time + problem.time_step);
        if (evenly) {
            state.velocity = (V + body.velocity) / 2;
            state.angular_momentum = (L + body.angular_momentum) / 2;
        }
        states[i] = fly(world, world.bodies[i], state, problem.time_step, counted, !flies);
        if (evenly) {
            states[i].velocity = body.velocity;
            states[i].angular_momentum = body.angular_momentum;
        }
        if (is_displaced) displace(states[i], displacements[i]);
    };
    for (const Island& island : problem.islands) {
        const bool evenly =
            is_of_higher_order(world.integrator) && is_held_evenly(problem, island, bounced);
        share_flights(*problem.team, island.bodies.size(), counters,
                      [&](std::size_t first, std::size_t last, Counters& counted) {
                          for (std::size_t at = first; at < last; ++at)
                              move_one(island.bodies[at], evenly, counted);
                      });
        counters.free_flights -= island.bodies.size();
    }
}

} // namespace rigor
