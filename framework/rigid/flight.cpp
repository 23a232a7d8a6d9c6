// SPDX-License-Identifier: MIT
#include "rigid/flight.hpp"

#include "formulas/inertia.hpp"
#include "formulas/rotation.hpp"
#include "geometry/pose.hpp"
#include "rigid/forces.hpp"
#include "rigid/gravity_flight.hpp"
#include "rigid/runge_kutta.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace rigor {

namespace {

constexpr double quarter_turn = std::numbers::pi / 2;
constexpr double most_substeps = 1000; // a body that needs more turns by 250 turns a step

Vector3d angular_velocity_of(Integrator integrator, const RigidBody& body, const RigidState& state)
{
    return inverse_inertia(integrator, body, state) * state.angular_momentum;
}

// A step of the methods that see one wrench for the whole step.
RigidState euler_step(Integrator integrator, const RigidBody& body, const RigidState& state,
                      const Wrench& wrench, double h)
{
    if (integrator == Integrator::linear)
        return step_symplectic_euler(state, body.inverse, wrench, h);
    if (integrator == Integrator::buss) return step_buss(state, body.inverse, wrench, h);

    RigidState next = state;
    next.velocity += h * body.inverse.inverse_mass * wrench.force;
    next.position += h * next.velocity;
    next.angular_momentum += h * wrench.torque;
    const Vector3d w = angular_velocity_of(integrator, body, next); // new L, old q
    next.orientation = advance_exact(state.orientation, w, h);
    return next;
}

RigidState one_step(Integrator integrator, const RigidBody& body, const RigidState& state,
                    const Wrench& wrench, double h)
{
    if (integrator == Integrator::matrix) {
        Track<MatrixScheme> track{body, MatrixScheme::from(state), wrench};
        runge_kutta_4(std::span(&track, 1), h, [](double) {});
        return MatrixScheme::to(track.stage, state);
    }
    if (integrator == Integrator::runge_kutta)
        return step_under_constant_wrench(body, state, wrench, h);
    return euler_step(integrator, body, state, wrench, h);
}

// How many equal substeps keep each below a quarter turn.
int substeps_for(Integrator integrator, const RigidBody& body, const RigidState& state, double h)
{
    if (integrator == Integrator::matrix) return 1;
    if (body.is_isotropic && integrator != Integrator::linear) return 1;
    // |ω| ≤ |I⁻¹| |L|: most bodies are slow enough to see without their ω. A NaN passes here, to be
    // reported by its quantity when the step is done.
    const double bound = body.inverse.inverse_inertia.norm() * state.angular_momentum.norm();
    if (!(bound * h > quarter_turn)) return 1;
    const double limit = max_time_step(angular_velocity_of(integrator, body, state));
    if (!(limit > 0))
        throw std::domain_error("max_time_step returned " + std::to_string(limit) + " for body '" +
                                body.name + "': expected a time > 0");
    return static_cast<int>(std::clamp(std::ceil(h / limit), 1.0, most_substeps));
}

// Unit again: rotations multiply their roundings up. The others make it so themselves.
RigidState with_unit_orientation(Integrator integrator, RigidState state)
{
    if (integrator != Integrator::matrix && integrator != Integrator::linear)
        state.orientation = normalize(state.orientation);
    return state;
}

int count_substeps(int n, Counters& counters)
{
    if (n > 1) counters.substeps += n;
    return n;
}

std::vector<Motion> motions_of(const World& world, const std::vector<bool>& pulled,
                               std::span<const RigidState> states)
{
    std::vector<Motion> motions(states.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
        const RigidState& s = states[i];
        const RigidBody& body = world.bodies[i];
        motions[i] = {Matrix3d::Identity(), s.position, s.velocity, Vector3d::Zero()};
        if (!pulled[i] && !body.is_static) continue; // nothing is attached here
        motions[i].R = body_rotation(world.integrator, s);
        motions[i].omega = angular_velocity_of(world.integrator, body, s);
    }
    return motions;
}

// Runge–Kutta 4 for the bodies in `together`, whose forces depend on each other at every stage.
template <class Scheme>
void fly_together(const World& world, const std::vector<bool>& pulled,
                  const std::vector<int>& together, std::vector<RigidState>& states, double h,
                  double time)
{
    std::vector<Track<Scheme>> tracks;
    for (int i : together)
        tracks.push_back({world.bodies[i], Scheme::from(states[i]), Wrench()});
    std::vector<RigidState> stage = states;
    runge_kutta_4(std::span(tracks), h, [&](double offset) {
        for (std::size_t k = 0; k < together.size(); ++k)
            stage[together[k]] = Scheme::to(tracks[k].stage, stage[together[k]]);
        const std::vector<Wrench> net =
            wrenches(world, motions_of(world, pulled, stage), time + offset);
        for (std::size_t k = 0; k < together.size(); ++k)
            tracks[k].wrench = net[together[k]];
    });
    for (std::size_t k = 0; k < together.size(); ++k)
        states[together[k]] = Scheme::to(tracks[k].stage, states[together[k]]);
}

void fly_pulled(const World& world, const std::vector<bool>& pulled,
                const std::vector<int>& together, std::vector<RigidState>& states, double h,
                double time)
{
    if (world.integrator == Integrator::matrix)
        return fly_together<MatrixScheme>(world, pulled, together, states, h, time);
    if (world.integrator == Integrator::runge_kutta)
        return fly_together<LieScheme>(world, pulled, together, states, h, time);
    const std::vector<Wrench> net = wrenches(world, motions_of(world, pulled, states), time);
    for (int i : together)
        states[i] = euler_step(world.integrator, world.bodies[i], states[i], net[i], h);
}

} // namespace

Matrix3d body_rotation(Integrator integrator, const RigidState& state)
{
    if (integrator == Integrator::matrix) return rotation_matrix(state.orientation);
    return to_matrix(state.orientation);
}

Matrix3d inverse_inertia(Integrator integrator, const RigidBody& body, const RigidState& state)
{
    const Matrix3d& I_inverse = body.inverse.inverse_inertia;
    if (body.is_static || body.is_isotropic) return I_inverse;
    return world_inverse_inertia(body_rotation(integrator, state), I_inverse);
}

RigidState fly(const World& world, const RigidBody& body, RigidState state, double time_step,
               Counters& counters, bool drifts)
{
    const bool is_exact = body.is_symmetric() && world.integrator == Integrator::runge_kutta;
    const int n =
        is_exact ? 1
                 : count_substeps(substeps_for(world.integrator, body, state, time_step), counters);
    if (body.is_isotropic) ++counters.isotropic_shortcuts;
    for (int i = 0; i < n; ++i) {
        const Wrench wrench = drifts ? Wrench() : gravity_on(world, body, state.position);
        state = one_step(world.integrator, body, state, wrench, time_step / n);
    }
    return with_unit_orientation(world.integrator, state);
}

std::vector<RigidState> fly_all(const World& world, const std::vector<bool>& pulled,
                                double time_step, Counters& counters, Team& team)
{
    std::vector<RigidState> states(world.bodies.size());
    std::vector<int> together;
    int n = 1;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const RigidBody& body = world.bodies[i];
        if (body.is_static) ++counters.static_skipped;
        if (body.rest.is_asleep()) ++counters.bodies_asleep;
        if (!pulled[i] || body.is_still()) continue;
        together.push_back(static_cast<int>(i));
        n = std::max(n, substeps_for(world.integrator, body, body.state, time_step));
        if (body.is_isotropic) ++counters.isotropic_shortcuts;
    }
    share_flights(team, states.size(), counters,
                  [&](std::size_t first, std::size_t last, Counters& counted) {
                      for (std::size_t i = first; i < last; ++i) {
                          const RigidBody& body = world.bodies[i];
                          states[i] = body.is_still() || pulled[i]
                                          ? body.state
                                          : fly(world, body, body.state, time_step, counted);
                      }
                  });
    if (together.empty()) return states;

    // Those that springs tie together but that fly alone have moved already: none is among them.
    count_substeps(n, counters);
    const double h = time_step / n;
    for (int k = 0; k < n; ++k)
        fly_pulled(world, pulled, together, states, h, world.time + k * h);
    for (int i : together)
        states[i] = with_unit_orientation(world.integrator, states[i]);
    return states;
}

} // namespace rigor
