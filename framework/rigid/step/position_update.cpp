// SPDX-License-Identifier: MIT
// The position update. Each body that got an impulse flies once more, by the integrator of free
// flight, with its velocity after the contact stage or, if it only bounced, after the collision
// stage (before the forces; then free flight adds gravity). The displacements of the position
// correction are added last.
#include "rigid/step/position_update.hpp"

#include "formulas/rotation.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/motion/free_flight.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// `has_bounced`: whether the collision stage gave a body an impulse; `has_contact_impulse`: whether
// the contact stage did. An impulse of the contact stage does not count if it changes a velocity
// only by a rounding error, as between bodies that fall together after a hit.
struct Impulses {
    bool has_bounced = false, has_contact_impulse = false;
};

bool holds(const ContactProblem& problem, const ContactConstraint& c)
{
    if (c.contact_impulse.isZero(0)) return false;
    const double rounding = problem.rounding_speed(c);
    return c.normal_K * c.contact_impulse.norm() > rounding || !std::isfinite(rounding);
}

std::vector<Impulses> impulses_of(const ContactProblem& problem)
{
    std::vector<Impulses> impulses(problem.bodies.size());
    for (const ContactConstraint& c : problem.contacts) {
        Impulses &first = impulses[c.body1], &second = impulses[c.body2];
        if (!c.collision_impulse.isZero(0)) first.has_bounced = second.has_bounced = true;
        if (first.has_contact_impulse && second.has_contact_impulse) continue;
        if (holds(problem, c)) first.has_contact_impulse = second.has_contact_impulse = true;
    }
    return impulses;
}

void displace(RigidState& state, const Displacement& by)
{
    state.position += by.shift;
    if (!by.turn.isZero(0)) state.orientation = advance_exact(state.orientation, by.turn, 1);
}

// Whether positions converge with an order above the first even where forces change within a step,
// as the forces of springs do. (`buss` has a higher order only without such forces.) If so, bodies
// that contacts hold should have a higher order too.
bool is_of_higher_order(Integrator integrator_under_forces)
{
    return integrator_under_forces == Integrator::runge_kutta ||
           integrator_under_forces == Integrator::matrix;
}

// Whether the contacts of an island act along the same normals during the whole step, as on an
// incline. On the wall of a bowl the normals change, and the mean of two velocities would add
// energy.
bool holds_along_fixed_normals(const ContactProblem& problem, const Island& island,
                               const std::vector<Body>& before)
{
    // A contact opens or closes if |v·n| is above this fraction of the speed of its bodies relative
    // to the ground. A smaller |v·n| is only an error that the sweeps leave; it moves no point by
    // more than 1e-6 of the distance that the bodies move. The limit also holds for the change of
    // v·n by the collision stage: between bodies that gravity accelerates alike, this change may be
    // tiny but not zero.
    constexpr double opens = 1e-6;
    // Between bodies at rest, the sweeps leave a |v·n| of at most this share of the speed that the
    // forces of the step add.
    constexpr double left_at_rest = 1e-12;
    const std::vector<Body> grounds = problem.grounds_of(island);
    const auto speed_of = [&](const Body& body) {
        double speed = 0;
        for (const Body& ground : grounds)
            speed = std::max(speed, (body.velocity - ground.velocity).norm());
        return speed;
    };
    for (const ContactPair& pair : island.pairs)
        for (int i = pair.first; i < pair.last; ++i) {
            const ContactConstraint& c = problem.contacts[i];
            const double hit = c.normal_K * c.collision_impulse.norm(); // change of v·n
            if (c.contact_impulse.isZero(0) && hit == 0) continue;
            const double none =
                std::max(left_at_rest * std::abs(c.force_speed), problem.rounding_speed(c));
            for (const std::vector<Body>* bodies : {&before, &problem.bodies}) {
                const double v_n = problem.velocity_between(*bodies, c, c.point).dot(c.normal);
                const double speed = speed_of((*bodies)[c.body1]) + speed_of((*bodies)[c.body2]);
                if (std::max(hit, std::abs(v_n)) > std::max(opens * speed, none)) return false;
            }
        }
    return true;
}

} // namespace

void update_positions(World& world, const ContactProblem& problem, const std::vector<bool>& pulled,
                      const std::vector<Body>& after_collisions,
                      const std::vector<Displacement>& displacements,
                      std::vector<RigidState>& states)
{
    Counters& counters = world.counters;
    const std::vector<Impulses> impulses = impulses_of(problem);
    const auto move = [&](int i, bool by_mean_velocity, Counters& counted) {
        const bool is_displaced = !displacements.empty() && !displacements[i].is_zero();
        const auto [has_bounced, has_contact_impulse] = impulses[i];
        if (!has_bounced && !has_contact_impulse) { // `states[i]` is that after free flight
            if (is_displaced) displace(states[i], displacements[i]);
            ++counted.free_flights;
            return;
        }
        const bool flies = !has_contact_impulse && !pulled[i];
        const Body& body = flies ? after_collisions[i] : problem.bodies[i];
        RigidState state = world.bodies[i].state;
        const Vector3d V = state.velocity, L = state.angular_momentum;
        state.velocity = body.velocity;
        state.angular_momentum = body.angular_momentum;
        require_finite(world.bodies[i], state, world.time + problem.time_step);
        if (by_mean_velocity) {
            state.velocity = (V + body.velocity) / 2;
            state.angular_momentum = (L + body.angular_momentum) / 2;
        }
        states[i] = fly(world.settings, world.bodies[i], state, problem.time_step, counted,
                        flies ? Gravity::acts : Gravity::left_out);
        if (by_mean_velocity) {
            states[i].velocity = body.velocity;
            states[i].angular_momentum = body.angular_momentum;
        }
        if (is_displaced) displace(states[i], displacements[i]);
    };
    for (const Island& island : problem.islands) {
        const bool by_mean_velocity =
            is_of_higher_order(world.settings.integrator_under_forces()) &&
            holds_along_fixed_normals(problem, island, after_collisions);
        fly_in_parallel(*problem.pool, island.bodies.size(), counters,
                        [&](std::size_t first, std::size_t last, Counters& counted) {
                            for (std::size_t at = first; at < last; ++at)
                                move(island.bodies[at], by_mean_velocity, counted);
                        });
        // stage 1 counted each body; only those count that keep their state after free flight
        counters.free_flights -= island.bodies.size();
    }
}

} // namespace rigor
