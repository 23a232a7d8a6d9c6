// SPDX-License-Identifier: MIT
#include "rigid/flight.hpp"

#include "formulas/inertia.hpp"
#include "formulas/rotation.hpp"
#include "geometry/shapes/pose.hpp"
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
        runge_kutta_4(std::span(&track, 1), h, [] {});
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

// Runge–Kutta 4 for the bodies in `together`, whose forces depend on each other at every stage.
// @param middle  of the step: the time [s]
template <class Scheme>
void fly_together(const World& world, Pulls& pulls, std::span<const int> together,
                  std::vector<RigidState>& states, double h, double middle)
{
    std::vector<Track<Scheme>> tracks;
    tracks.reserve(together.size());
    for (int i : together)
        tracks.push_back({world.bodies[i], Scheme::from(states[i]), Wrench()});
    runge_kutta_4(std::span(tracks), h, [&] {
        for (std::size_t k = 0; k < together.size(); ++k)
            states[together[k]] = Scheme::to(tracks[k].stage, states[together[k]]);
        const std::vector<Wrench>& net = pulls.at(states, middle);
        for (std::size_t k = 0; k < together.size(); ++k)
            tracks[k].wrench = net[k];
    });
    for (std::size_t k = 0; k < together.size(); ++k)
        states[together[k]] = Scheme::to(tracks[k].stage, states[together[k]]);
}

// Kicks, and free flights between them, by the method of Blanes and Moan: see the header.
void fly_by_kicks(const World& world, Pulls& pulls, std::span<const int> together,
                  std::vector<RigidState>& states, double h, double middle)
{
    constexpr double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
    constexpr double a1 = 0.245298957184271, a2 = 0.604872665711080;
    constexpr double a3 = 0.5 - (a1 + a2), b4 = 1 - 2 * (b1 + b2 + b3);
    constexpr double kicks[] = {b1, b2, b3, b4, b3, b2, b1};
    constexpr double flights[] = {a1, a2, a3, a3, a2, a1};
    for (std::size_t s = 0; s < std::size(kicks); ++s) {
        const std::vector<Wrench>& net = pulls.at(states, middle);
        for (std::size_t k = 0; k < together.size(); ++k) {
            const RigidBody& body = world.bodies[together[k]];
            RigidState& state = states[together[k]];
            state.velocity += kicks[s] * h * body.inverse.inverse_mass * net[k].force;
            state.angular_momentum += kicks[s] * h * net[k].torque;
            if (s < std::size(flights))
                state = step_under_constant_wrench(body, state, Wrench(), flights[s] * h);
        }
    }
}

void fly_pulled(const World& world, Pulls& pulls, std::span<const int> together,
                std::vector<RigidState>& states, double h, double middle)
{
    if (world.integrator == Integrator::matrix)
        return fly_together<MatrixScheme>(world, pulls, together, states, h, middle);
    if (world.integrator == Integrator::runge_kutta && pulls.any_damps())
        return fly_together<LieScheme>(world, pulls, together, states, h, middle);
    if (world.integrator == Integrator::runge_kutta)
        return fly_by_kicks(world, pulls, together, states, h, middle);
    const std::vector<Wrench>& net = pulls.at(states, middle);
    for (std::size_t k = 0; k < together.size(); ++k) {
        const int i = together[k];
        states[i] = euler_step(world.integrator, world.bodies[i], states[i], net[k], h);
    }
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
    Pulls pulls(world, together);
    for (int k = 0; k < n; ++k)
        fly_pulled(world, pulls, together, states, h, world.time + (k + 0.5) * h);
    for (int i : together)
        states[i] = with_unit_orientation(world.integrator, states[i]);
    return states;
}

} // namespace rigor
